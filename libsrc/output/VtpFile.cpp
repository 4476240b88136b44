// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/VtpFile.hpp"

#include "core/Error.hpp"
#include "output/VtkMessages.hpp"
#include "output/WholeFile.hpp"

#include <fmt/core.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <exception>
#include <limits>

namespace isph {

static_assert(sizeof(Vector3) == 3 * sizeof(Real), "vectors are handed to VTK as 3 numbers each");

namespace {

void addReals(vtkFieldData& data, const std::string& name, const Real* values, std::size_t tuples,
              int components)
{
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    // save = 1: VTK neither frees nor writes to memory that a const ParticleFile owns.
    array->SetArray(const_cast<Real*>(values), static_cast<vtkIdType>(tuples) * components, 1);
    data.AddArray(array);
}

/// A copy, as VTK's 64-bit integer is another type (long long) than std::int64_t (long).
template <class Value>
void addIntegers(vtkFieldData& data, const std::string& name, const std::vector<Value>& values)
{
    vtkNew<vtkTypeInt64Array> array;
    array->SetName(name.c_str());
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
        array->SetValue(static_cast<vtkIdType>(i), static_cast<vtkTypeInt64>(values[i]));
    data.AddArray(array);
}

void requireLength(const std::string& name, std::size_t length, const ParticleFile& particles)
{
    if (length == particles.size()) return;
    throw FatalError(
        fmt::format("field {} has {} values for {} particles", name, length, particles.size()));
}

void addPointData(vtkPolyData& poly, const ParticleFile& particles)
{
    vtkFieldData& data = *poly.GetPointData();
    for (const auto& [name, values] : particles.scalars) {
        requireLength(name, values.size(), particles);
        addReals(data, name, values.data(), values.size(), 1);
    }
    for (const auto& [name, values] : particles.vectors) {
        requireLength(name, values.size(), particles);
        const Real* first = values.empty() ? nullptr : values.front().data();
        addReals(data, name, first, values.size(), 3);
    }
    for (const auto& [name, values] : particles.integers) {
        requireLength(name, values.size(), particles);
        addIntegers(data, name, values);
    }
}

void addFieldData(vtkPolyData& poly, const ParticleFile& particles)
{
    vtkFieldData& data = *poly.GetFieldData();
    for (const auto& [name, values] : particles.names) {
        vtkNew<vtkStringArray> array;
        array->SetName(name.c_str());
        for (const std::string& value : values) array->InsertNextValue(value);
        data.AddArray(array);
    }
    for (const auto& [name, values] : particles.numbers) {
        if (name == "dimension")
            addIntegers(data, name, values);
        else
            addReals(data, name, values.data(), values.size(), 1);
    }
}

void addPoints(vtkPolyData& poly, const ParticleFile& particles)
{
    const auto count = static_cast<vtkIdType>(particles.size());
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    if (count > 0)
        coordinates->SetArray(const_cast<Real*>(particles.points.front().data()), 3 * count, 1);
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    points->SetData(coordinates);
    poly.SetPoints(points);

    vtkNew<vtkCellArray> vertices;
    if (count < std::numeric_limits<std::int32_t>::max()) vertices->Use32BitStorage();
    vertices->AllocateExact(count, count);
    for (vtkIdType i = 0; i < count; ++i) vertices->InsertNextCell(1, &i);
    poly.SetVerts(vertices);
}

template <class Get>
void readPointArray(const std::string& source, vtkDataArray& array, Get&& get, ParticleFile& out)
{
    const std::string name = array.GetName() ? array.GetName() : "";
    const int components = array.GetNumberOfComponents();
    const vtkIdType count = array.GetNumberOfTuples();
    if (name.empty()) throw FatalIOError("a point data array has no name", source, 0);
    if (static_cast<std::size_t>(count) != out.size())
        throw FatalIOError(
            fmt::format("field {} has {} values for {} particles", name, count, out.size()), source,
            0);
    const bool whole = array.GetDataType() != VTK_DOUBLE && array.GetDataType() != VTK_FLOAT;
    if (components == 3 && !whole) {
        auto& values = out.vectors[name];
        values.resize(out.size());
        for (vtkIdType i = 0; i < count; ++i) get(i, values[static_cast<std::size_t>(i)].data());
    } else if (components == 1 && !whole) {
        auto& values = out.scalars[name];
        values.resize(out.size());
        for (vtkIdType i = 0; i < count; ++i) get(i, &values[static_cast<std::size_t>(i)]);
    } else if (components == 1) {
        auto& values = out.integers[name];
        values.resize(out.size());
        for (vtkIdType i = 0; i < count; ++i)
            values[static_cast<std::size_t>(i)] = array.GetVariantValue(i).ToTypeInt64();
    } else {
        throw FatalIOError(
            fmt::format("field {} has {} components of type {}; reals with 1 or 3 components "
                        "or integers with 1 are expected",
                        name, components, array.GetDataTypeAsString()),
            source, 0);
    }
}

void readPointData(vtkPolyData& poly, ParticleFile& out)
{
    vtkPointData& data = *poly.GetPointData();
    for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
        vtkDataArray* array = data.GetArray(a);
        if (!array) throw FatalIOError("point data that are no numbers", out.source, 0);
        readPointArray(
            out.source, *array, [&](vtkIdType i, Real* to) { array->GetTuple(i, to); }, out);
    }
}

void readFieldData(vtkPolyData& poly, ParticleFile& out)
{
    vtkFieldData& data = *poly.GetFieldData();
    for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
        vtkAbstractArray* array = data.GetAbstractArray(a);
        const std::string name = array->GetName() ? array->GetName() : "";
        if (auto* text = vtkStringArray::SafeDownCast(array)) {
            auto& values = out.names[name];
            for (vtkIdType i = 0; i < text->GetNumberOfValues(); ++i)
                values.push_back(text->GetValue(i));
        } else if (auto* numeric = vtkDataArray::SafeDownCast(array)) {
            auto& values = out.numbers[name];
            for (vtkIdType i = 0; i < numeric->GetNumberOfTuples(); ++i)
                for (int c = 0; c < numeric->GetNumberOfComponents(); ++c)
                    values.push_back(numeric->GetComponent(i, c));
        }
    }
}

template <class Value>
const Value& present(const std::map<std::string, Value>& fields, const std::string& name,
                     const std::string& kind, const std::string& source)
{
    const auto it = fields.find(name);
    if (it != fields.end()) return it->second;
    std::vector<std::string> names;
    for (const auto& field : fields) names.push_back(field.first);
    throw FatalIOError(fmt::format("{} {} is missing; present:\n{}", kind, name, listOf(names)),
                       source, 0);
}

}  // namespace

const std::vector<Real>& ParticleFile::scalar(const std::string& name) const
{
    return present(scalars, name, "scalar field", source);
}

const std::vector<Vector3>& ParticleFile::vector(const std::string& name) const
{
    return present(vectors, name, "vector field", source);
}

const std::vector<std::int64_t>& ParticleFile::integer(const std::string& name) const
{
    return present(integers, name, "integer field", source);
}

const std::vector<std::string>& ParticleFile::nameList(const std::string& name) const
{
    return present(names, name, "list of names", source);
}

Real ParticleFile::number(const std::string& name) const
{
    const std::vector<Real>& values = present(numbers, name, "number", source);
    if (values.size() != 1)
        throw FatalIOError(fmt::format("{} has {} values where 1 is expected", name, values.size()),
                           source, 0);
    return values.front();
}

namespace {
/// What stands in the file, without checksum. VTK's own copies of it end with this function.
std::string fileText(const std::filesystem::path& file, const ParticleFile& particles)
{
    vtkNew<vtkPolyData> poly;
    addPoints(*poly, particles);
    addPointData(*poly, particles);
    addFieldData(*poly, particles);

    const VtkMessages messages;
    vtkNew<vtkXMLPolyDataWriter> writer;
    vtkNew<vtkLZ4DataCompressor> lz4;
    writer->SetInputData(poly);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetHeaderTypeToUInt64();
    writer->SetCompressor(lz4);
    writer->WriteToOutputStringOn();
    if (!writer->Write() || messages.failed())
        throw FatalIOError("cannot write particles: " + messages.first(), file.string(), 0);
    return writer->GetOutputString();
}
}  // namespace

void writeParticleFile(const std::filesystem::path& file, const ParticleFile& particles)
{
    writeWholeFile(file, withChecksum(fileText(file, particles)));
}

ParticleFile readParticleFile(const std::filesystem::path& file)
{
    ParticleFile out;
    out.source = file.string();
    const std::string content = readWholeFile(file);
    if (content.find("type=\"PolyData\"") >= 1024)  // stands in the first line of the file
        throw FatalIOError("this is no VTK XML poly data file (.vtp)", out.source, 0);
    requireUndamaged(content, "</VTKFile>", out.source);

    const VtkMessages messages;
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(content);
    try {
        reader->Update();
    } catch (const std::exception& error) {  // an impossible size asked for by damaged data
        throw FatalIOError(std::string("cannot read particles: ") + error.what(), out.source, 0);
    }
    vtkPolyData* poly = reader->GetOutput();
    if (messages.failed() || reader->GetErrorCode() != 0 || !poly)
        throw FatalIOError("cannot read particles, the file is damaged: " + messages.first(),
                           out.source, 0);

    out.points.resize(static_cast<std::size_t>(poly->GetNumberOfPoints()));
    for (std::size_t i = 0; i < out.size(); ++i)
        poly->GetPoint(static_cast<vtkIdType>(i), out.points[i].data());
    readPointData(*poly, out);
    readFieldData(*poly, out);
    return out;
}

}  // namespace isph
