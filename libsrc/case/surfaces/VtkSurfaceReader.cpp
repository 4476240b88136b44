// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of triangles from STL, OBJ and VTP files, by VTK.
#include "case/SurfaceReader.hpp"
#include "core/Error.hpp"

#include <fmt/core.h>
#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>

namespace isph {

namespace {

template <class Reader>
vtkSmartPointer<vtkPolyData> readWith(const std::filesystem::path& file)
{
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> readFile(const std::filesystem::path& file)
{
    if (!std::filesystem::is_regular_file(file))
        throw FatalError(fmt::format("cannot open the surface \"{}\"", file.string()));
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    if (ending == ".stl") return readWith<vtkSTLReader>(file);
    if (ending == ".obj") return readWith<vtkOBJReader>(file);
    if (ending == ".vtp") return readWith<vtkXMLPolyDataReader>(file);
    throw FatalError(fmt::format(
        "the surface \"{}\" is of unknown format; valid are .stl, .obj and .vtp", file.string()));
}

/// Triangles with merged points and normals out of the body; throws unless they close.
vtkSmartPointer<vtkPolyData> closedSurface(const std::filesystem::path& file)
{
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(readFile(file));
    triangles->PassLinesOff();
    triangles->PassVertsOff();
    vtkNew<vtkCleanPolyData> clean;
    clean->SetInputConnection(triangles->GetOutputPort());
    clean->SetTolerance(1e-9);
    clean->Update();
    if (clean->GetOutput()->GetNumberOfPolys() == 0)
        throw FatalError(fmt::format("the surface \"{}\" holds no triangles", file.string()));

    vtkNew<vtkFeatureEdges> open;
    open->SetInputConnection(clean->GetOutputPort());
    open->BoundaryEdgesOn();
    open->NonManifoldEdgesOn();
    open->FeatureEdgesOff();
    open->ManifoldEdgesOff();
    open->Update();
    if (const auto count = open->GetOutput()->GetNumberOfLines(); count > 0)
        throw FatalError(
            fmt::format("the surface \"{}\" is not closed: {} open edges (edges that do not "
                        "belong to exactly two triangles)",
                        file.string(), count));

    vtkNew<vtkPolyDataNormals> orient;
    orient->SetInputConnection(clean->GetOutputPort());
    orient->ConsistencyOn();
    orient->AutoOrientNormalsOn();
    orient->SplittingOff();
    orient->ComputeCellNormalsOn();
    orient->Update();
    return orient->GetOutput();
}

class VtkSurfaceReader : public SurfaceReader {
public:
    explicit VtkSurfaceReader(const Dictionary&) {}
    TriangleSurface read(const std::filesystem::path& file) const override;
};

TriangleSurface VtkSurfaceReader::read(const std::filesystem::path& file) const
{
    const vtkSmartPointer<vtkPolyData> poly = closedSurface(file);
    TriangleSurface surface;
    surface.corners.resize(static_cast<std::size_t>(poly->GetNumberOfPoints()));
    for (std::size_t i = 0; i < surface.corners.size(); ++i)
        poly->GetPoint(static_cast<vtkIdType>(i), surface.corners[i].c.data());
    vtkNew<vtkIdList> ids;
    vtkCellArray* polys = poly->GetPolys();
    for (polys->InitTraversal(); polys->GetNextCell(ids);)
        surface.triangles.push_back({static_cast<Index>(ids->GetId(0)),
                                     static_cast<Index>(ids->GetId(1)),
                                     static_cast<Index>(ids->GetId(2))});
    return surface;
}

const SurfaceReader::Table::Entry<VtkSurfaceReader> entry{"VTK"};

}  // namespace

}  // namespace isph
