// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/SurfaceShape.hpp"

#include "case/PolygonShape.hpp"

#include <fmt/core.h>
#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkCutter.h>
#include <vtkFeatureEdges.h>
#include <vtkIdList.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkObject.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <mutex>

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

Point crossProduct(const Point& a, const Point& b)
{
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

}  // namespace

struct SurfaceShape::Content {
    vtkSmartPointer<vtkPolyData> surface;
    vtkNew<vtkImplicitPolyDataDistance> distance;
    mutable std::mutex oneAtATime;  // VTK's evaluation is not for several threads
    BoundingBox bounds;
    Real volume = 0;
};

SurfaceShape::SurfaceShape(const std::filesystem::path& file)
    : content_(std::make_unique<Content>())
{
    content_->surface = closedSurface(file);
    content_->distance->SetInput(content_->surface);
    forEachTriangle(*content_->surface, [&](const Point& a, const Point& b, const Point& c) {
        for (const Point& p : {a, b, c}) content_->bounds.include(p);
        content_->volume += dot(a, crossProduct(b, c)) / 6;
    });
}

SurfaceShape::~SurfaceShape() = default;

Real SurfaceShape::signedDistance(const Point& x) const
{
    Point p = x;
    const std::lock_guard lock(content_->oneAtATime);
    return content_->distance->EvaluateFunction(p.c.data());
}

Point SurfaceShape::nearestPoint(const Point& x) const
{
    Point p = x, nearest;
    const std::lock_guard lock(content_->oneAtATime);
    content_->distance->EvaluateFunctionAndGetClosestPoint(p.c.data(), nearest.c.data());
    return nearest;
}

Point SurfaceShape::normal(const Point& x) const
{
    const Point away = x - nearestPoint(x);
    if (norm(away) > 1e-9 * norm(content_->bounds.size()))
        return signedDistance(x) < 0 ? -unit(away) : unit(away);
    Point p = x, n;
    const std::lock_guard lock(content_->oneAtATime);
    content_->distance->EvaluateGradient(p.c.data(), n.c.data());
    return unit(n);
}

BoundingBox SurfaceShape::bounds() const
{
    return content_->bounds;
}

std::optional<Real> SurfaceShape::volume() const
{
    return std::fabs(content_->volume);
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
