// The extension module delabole._delabole, on which the Python package of this folder is built.
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/section.hpp"
#include "cases/program/reader/unit_system.hpp"
#include "cases/program/terminal/options.hpp"
#include "cases/python/case_object.hpp"
#include "cases/python/schema.hpp"
#include "cases/python/simulation_object.hpp"
#include "cases/python/tree.hpp"
#include "version/version.hpp"

#include <pybind11/stl.h>

#include <exception>

namespace delabole {

namespace py = pybind11;

namespace {

py::list schema() {
    py::list classes;
    for (const ClassSchema& one : described_classes()) {
        py::list fields;
        for (const FieldSchema& field : one.fields) {
            py::dict made;
            made["key"] = field.key;
            made["meaning"] = field.meaning;
            made["kind"] = word_of(field.kind);
            made["optional"] = field.optional;
            made["dimension"] = static_cast<int>(field.dimension);
            made["unit"] = std::string(dimension_words(field.dimension).si_symbol);
            made["range"] =
                py::make_tuple(field.range.lower, field.range.upper, field.range.lower_open, field.range.upper_open);
            made["range_in_words"] = readable_range(field.range, field.dimension);
            made["words"] = field.words;
            made["classes"] = field.classes;
            fields.append(made);
        }
        py::dict made;
        made["name"] = one.name;
        made["meaning"] = one.meaning;
        made["kind_key"] = one.kind_key;
        made["kind"] = one.kind;
        made["fields"] = fields;
        classes.append(made);
    }
    return classes;
}

using RangeOfField = std::tuple<double, double, bool, bool>;

// A number of a section in SI, from a text with its unit; raises the reader's complaint if it is wrong.
double number_of(const std::string& section, const std::string& key, const py::object& given, int dimension,
                 const RangeOfField& range) {
    const auto& [lower, upper, lower_open, upper_open] = range;
    const Interval allowed{lower, upper, lower_open, upper_open};
    Node node = tree_of(given);
    const bool bare = node.kind == Node::Kind::integer || node.kind == Node::Kind::real;
    if (bare && dimension != static_cast<int>(Dimension::ratio)) {
        node.text = shortest_number(node.real) + " " +
                    std::string(dimension_words(static_cast<Dimension>(dimension)).si_symbol);
        node.kind = Node::Kind::text;
    }
    Reading reading(section);
    const auto read = read_number(reading, node, key, static_cast<Dimension>(dimension), allowed);
    reading.finish();
    return *read;
}

// Raises the exception with an attribute `problems`, which lists file, line, column, key, value and message of each.
void translate(const py::handle& case_error, std::exception_ptr thrown) {
    try {
        std::rethrow_exception(std::move(thrown));
    } catch (const CaseError& error) {
        std::vector<Problem> found = error.problems();
        py::list problems;
        for (Problem& problem : found) {
            // What the command line gives by --set, a program in Python gives by settings.
            problem.file = problem.file == "--set" ? "settings" : problem.file;
            problems.append(py::make_tuple(problem.file, problem.line, problem.column, problem.key, problem.value,
                                           problem.message));
        }
        const py::object raised = case_error(CaseError(found).what());
        raised.attr("problems") = problems;
        PyErr_SetObject(case_error.ptr(), raised.ptr());
    } catch (const UsageError& error) {
        PyErr_SetString(PyExc_ValueError, error.what());
    }
}

}  // namespace

PYBIND11_MODULE(_delabole, module) {
    module.attr("__version__") = version();
    // This object is never destroyed, because other threads may raise it until the process ends.
    static const py::handle case_error = py::exception<CaseError>(module, "CaseError", PyExc_ValueError).release();
    case_error.attr("__module__") = "delabole";
    py::register_exception_translator([](std::exception_ptr thrown) { translate(case_error, std::move(thrown)); });
    module.def("schema", &schema);
    module.def("number", &number_of, py::arg("section"), py::arg("key"), py::arg("given"), py::arg("dimension"),
               py::arg("range"));
    bind_cases(module);
    bind_simulation(module);
}

}  // namespace delabole
