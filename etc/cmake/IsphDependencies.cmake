# The libraries that the project builds on; etc/installDependencies names their Debian packages.
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(fmt REQUIRED)
find_package(Boost REQUIRED COMPONENTS program_options)
find_package(PkgConfig REQUIRED)
pkg_check_modules(muparser REQUIRED IMPORTED_TARGET muparser)
find_path(SUITESPARSE_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_path(HYPRE_INCLUDE_DIR HYPRE.h PATH_SUFFIXES hypre REQUIRED)
find_library(HYPRE_LIBRARY HYPRE REQUIRED)
find_package(MPI REQUIRED COMPONENTS CXX)
find_package(VTK 9 REQUIRED COMPONENTS CommonCore CommonDataModel CommonExecutionModel
    IOXML IOGeometry IOImage FiltersCore FiltersGeneral FiltersSources)
