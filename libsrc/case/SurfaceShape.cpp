// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/SurfaceShape.hpp"

#include "case/PolygonShape.hpp"

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

template <class F>
void forEachTriangle(vtkPolyData& surface, F&& f)
{
    vtkNew<vtkIdList> ids;
    vtkCellArray* polys = surface.GetPolys();
    for (polys->InitTraversal(); polys->GetNextCell(ids);) {
        Point corner[3];
        for (int k = 0; k < 3; ++k) surface.GetPoint(ids->GetId(k), corner[k].c.data());
        f(corner[0], corner[1], corner[2]);
    }
}

TriangleTree treeOf(vtkPolyData& surface)
{
    std::vector<Point> corners(static_cast<std::size_t>(surface.GetNumberOfPoints()));
    for (std::size_t i = 0; i < corners.size(); ++i)
        surface.GetPoint(static_cast<vtkIdType>(i), corners[i].c.data());
    std::vector<TriangleTree::Triangle> triangles;
    vtkNew<vtkIdList> ids;
    vtkCellArray* polys = surface.GetPolys();
    for (polys->InitTraversal(); polys->GetNextCell(ids);)
        triangles.push_back({static_cast<Index>(ids->GetId(0)), static_cast<Index>(ids->GetId(1)),
                             static_cast<Index>(ids->GetId(2))});
    Real volume = 0;
    for (const auto& t : triangles)
        volume += dot(corners[t[0]], crossProduct(corners[t[1]], corners[t[2]]));
    if (volume < 0)  // inside out
        for (auto& t : triangles) std::swap(t[1], t[2]);
    return TriangleTree(std::move(corners), std::move(triangles));
}

}  // namespace

SurfaceShape::SurfaceShape(const std::filesystem::path& file) : tree_(treeOf(*closedSurface(file)))
{
}

Real SurfaceShape::signedDistance(const Point& x) const
{
    return tree_.nearest(x).distance;
}

Point SurfaceShape::nearestPoint(const Point& x) const
{
    return tree_.nearest(x).point;
}

Point SurfaceShape::normal(const Point& x) const
{
    const TriangleTree::Foot foot = tree_.nearest(x);
    if (std::fabs(foot.distance) > 1e-9 * norm(tree_.bounds().size()))
        return (x - foot.point) / foot.distance;
    return unit(foot.normal);
}

std::unique_ptr<Shape> surfaceSection(const std::filesystem::path& file, std::optional<Real> z)
{
    const vtkSmartPointer<vtkPolyData> surface = closedSurface(file);
    double b[6];
    surface->GetBounds(b);
    const Real height = z.value_or(0.5 * (b[4] + b[5]));
    // edges of the section with the interior on their left: along normal x e_z, turned by a right
    // angle
    std::vector<Edge> edges;
    forEachTriangle(*surface, [&](const Point& p, const Point& q, const Point& r) {
        const Point corner[3] = {p, q, r};
        Vec<2> from, to;
        bool hasFrom = false, hasTo = false;
        for (int k = 0; k < 3; ++k) {
            const Point &a = corner[k], &c = corner[(k + 1) % 3];
            const bool below = a[2] < height, belowNext = c[2] < height;
            if (below == belowNext) continue;
            // the crossing depends on the edge alone, not on the triangle, so that pieces join
            const Point &lo = below ? a : c, &hi = below ? c : a;
            const Real s = (height - lo[2]) / (hi[2] - lo[2]);
            const Vec<2> at{{lo[0] + s * (hi[0] - lo[0]), lo[1] + s * (hi[1] - lo[1])}};
            (below ? to : from) = at;
            (below ? hasTo : hasFrom) = true;
        }
        if (hasFrom && hasTo && norm(to - from) > 0) edges.push_back({from, to, 0, false});
    });
    if (edges.empty())
        throw FatalError(
            fmt::format("the plane z = {} does not cut the surface \"{}\", which reaches from "
                        "z = {} to {}",
                        height, file.string(), b[4], b[5]));
    if (enclosedArea(edges) < 0)
        for (Edge& e : edges) std::swap(e.a, e.b);
    return std::make_unique<PolygonShape>(std::move(edges), 2, 0, 0);
}

}  // namespace isph
