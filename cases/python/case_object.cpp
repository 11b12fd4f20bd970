#include "cases/python/case_object.hpp"

#include "cases/program/case/case_writer.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/sweeps/support_report.hpp"
#include "cases/python/background.hpp"
#include "cases/python/fit_object.hpp"
#include "cases/python/tree.hpp"
#include "cases/python/vectorised.hpp"
#include "fitting/probability/sampling.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <map>
#include <optional>

namespace delabole {

namespace py = pybind11;

namespace {

using Column = py::array_t<double, py::array::c_style>;

std::vector<Setting> settings_of(const std::map<std::string, std::string>& given) {
    std::vector<Setting> settings;
    for (const auto& [key, value] : given) {
        settings.push_back({key, value});
    }
    return settings;
}

py::list list_of(const std::vector<Quantity>& quantities) {
    py::list list;
    for (const Quantity& quantity : quantities) {
        list.append(
            py::make_tuple(quantity.name, display_unit(quantity.dimension).symbol, quantity.meaning, quantity.value));
    }
    return list;
}

py::dict run_case(const CaseObject& object, const py::object& progress, unsigned threads) {
    CaseFile file = object.file;
    std::optional<DesignedSupport> support;
    Analysis analysis;
    HeadCard head;
    in_background(progress, [&](BackgroundWatch& watch) {
        support = design_support_of(file, telling(watch, "patterns of support"));
        AnalysisWork work;
        work.threads = threads;
        work.watch = [&](double share, const std::string& what, bool) {
            watch.tell(share, what);
            return !watch.stopped();
        };
        const CaseAnswer answer = analyse_case(file.model, work);
        analysis = named_outputs(file.model, answer);
        if (analysis.failure.empty()) {
            head = head_card(file.model, answer);
        }
    });
    if (!analysis.failure.empty()) {
        throw CaseError({impossible(file, analysis.failure)});
    }
    py::dict values;
    py::dict meanings;
    for (const NamedOutput& output : analysis.outputs) {
        values[py::str(output.name)] = py::cast(output.value);
        meanings[py::str(output.name)] = py::make_tuple(display_unit(output.dimension).symbol, output.meaning);
    }
    py::dict result;
    result["values"] = values;
    result["meanings"] = meanings;
    result["status"] = analysis.status;
    result["unfinished"] = analysis.unfinished;
    result["warnings"] = analysis.warnings;
    Json json = json_of(file, analysis);
    if (support) {
        Report unused;
        json["support_design"] = document_support(*support, {ResultFolder(), unused});
        add_to_head(*support, head);
    }
    result["sentences"] = head.sentences;
    result["json"] = json_text(json);
    return result;
}

std::size_t place_among(const std::vector<Quantity>& quantities, const std::string& name, const char* what) {
    const auto place = place_of(quantities, name);
    if (!place) {
        throw py::key_error("the case has no " + std::string(what) + " '" + name + "'" +
                            suggestion(name, names_in(quantities)));
    }
    return *place;
}

// SI value of "30 deg" for an input.
double input_value(const CaseObject& object, const std::string& name, const std::string& text) {
    const std::vector<Quantity> inputs = named_inputs(object.file.model);
    const ParsedQuantity read = parse_quantity(text, inputs[place_among(inputs, name, "input")].dimension);
    if (read.status != QuantityStatus::ok) {
        throw py::value_error(name + " = '" + text + "': " + read.message);
    }
    return read.value;
}

// The model that run() and sensitivity() use: with the support that its case has designed.
const CaseModel& supported_model(const CaseObject& object, const py::object& progress) {
    if (!object.file.support_design) {
        return object.file.model;
    }
    if (!object.supported) {
        CaseFile file = object.file;
        in_background(progress,
                      [&](BackgroundWatch& watch) { design_support_of(file, telling(watch, "patterns of support")); });
        object.supported = std::move(file.model);
    }
    return *object.supported;
}

// Evaluates the case at `count` points. `inputs` holds columns of equal length by the names of inputs. Returns the
// outputs asked for, for each point the number of its cause of failure, and the list of causes.
py::tuple evaluate_case(const CaseObject& object, const std::map<std::string, Column>& inputs, std::size_t count,
                        const std::vector<std::string>& outputs, const py::object& progress, int threads) {
    const CaseModel& supported = supported_model(object, progress);
    const ModelInterface model = interface_of(supported);
    PointColumns columns;
    columns.count = count;
    for (const auto& [name, values] : inputs) {
        if (static_cast<std::size_t>(values.size()) != count) {
            throw py::value_error("the columns of inputs differ in length");
        }
        columns.inputs.push_back(place_among(model.inputs, name, "input"));
        columns.input_values.push_back(values.data());
    }
    std::vector<Column> answers;
    for (const std::string& name : outputs) {
        columns.outputs.push_back(place_among(model.outputs, name, "output"));
        columns.output_values.push_back(answers.emplace_back(static_cast<py::ssize_t>(count)).mutable_data());
    }
    py::array_t<std::int16_t> failures(static_cast<py::ssize_t>(count));
    columns.failures = failures.mutable_data();
    std::vector<std::string> causes;
    in_background(progress, [&](BackgroundWatch& watch) {
        causes = evaluate_points(supported, columns,
                                 {threads, watch.stop_flag(), [&](double share) { watch.tell(share, "points"); }});
    });
    return py::make_tuple(answers, failures, causes);
}

const SensitivityStudy& sensitivity_of(const CaseFile& file) {
    require_section(file.sensitivity.has_value(), file, "sensitivity");
    return *file.sensitivity;
}

// Samples of the uncertain parameters of [sensitivity], by name; arguments that are absent are taken from its
// propagation.
py::dict sample_case(const CaseObject& object, std::optional<long> samples, const std::optional<std::string>& method,
                     std::optional<std::uint64_t> seed) {
    const SensitivityStudy& study = sensitivity_of(object.file);
    // This raises every complaint about distributions and correlations; the problem itself is not needed.
    sensitivity_problem_of(object.file, 1, seed);
    PropagationSettings settings = study.propagation.value_or(PropagationSettings{});
    settings.samples = samples.value_or(settings.samples);
    if (settings.samples < 1 || settings.samples > most_samples) {
        throw py::value_error("samples must be from 1 to " + std::to_string(most_samples));
    }
    if (method) {
        const auto known = value_of<SamplingMethod>(*method);
        if (!known) {
            throw py::value_error("'" + *method + "' is no method of sampling");
        }
        settings.method = *known;
    }
    std::vector<std::vector<double>> columns(study.parameters.size());
    {
        const py::gil_scoped_release released;
        const InputSpace space = input_space(study);
        const SamplePlan plan = plan_of(settings, space.size(), seed.value_or(study.seed));
        std::vector<double> point(space.size());
        std::vector<double> values(space.size());
        for (std::vector<double>& column : columns) {
            column.resize(plan.size());
        }
        for (std::size_t index = 0; index < plan.size(); ++index) {
            plan.point(index, point);
            space.values_of_unit(point, values);
            for (std::size_t parameter = 0; parameter < values.size(); ++parameter) {
                columns[parameter][index] = values[parameter];
            }
        }
    }
    py::dict arrays;
    for (std::size_t parameter = 0; parameter < columns.size(); ++parameter) {
        const Column array(static_cast<py::ssize_t>(columns[parameter].size()), columns[parameter].data());
        arrays[py::str(study.parameters[parameter].name)] = array;
        for (const std::string& other : study.parameters[parameter].also) {
            arrays[py::str(other)] = array;
        }
    }
    return arrays;
}

}  // namespace

void bind_cases(py::module_& module) {
    py::class_<CaseObject>(module, "Case")
        .def_static(
            "read",
            [](const std::string& path, const std::map<std::string, std::string>& settings) {
                return CaseObject{read_case(path, settings_of(settings))};
            },
            py::arg("path"), py::arg("settings"))
        .def_static(
            "parse",
            [](const std::string& text, const std::string& name, const std::map<std::string, std::string>& settings) {
                return CaseObject{parse_case(text, name, settings_of(settings))};
            },
            py::arg("text"), py::arg("name"), py::arg("settings"))
        .def_static(
            "of_tree",
            [](const py::dict& tree, const std::string& name) { return CaseObject{case_of_tree(tree_of(tree), name)}; },
            py::arg("tree"), py::arg("name"))
        .def_property_readonly("name", [](const CaseObject& object) { return object.file.name; })
        .def_property_readonly("title", [](const CaseObject& object) { return object.file.title; })
        .def_property_readonly("description", [](const CaseObject& object) { return object.file.description; })
        .def_property_readonly("model_name", [](const CaseObject& object) { return model_name(object.file.model); })
        .def_property_readonly("model_tree",
                               [](const CaseObject& object) {
                                   return object_of(parse_document(resolved_model(object.file.model), "model"));
                               })
        .def_property_readonly("toml", [](const CaseObject& object) { return resolved_toml(object.file); })
        .def_property_readonly("hash", [](const CaseObject& object) { return case_hash(object.file); })
        .def_property_readonly("inputs",
                               [](const CaseObject& object) { return list_of(interface_of(object.file.model).inputs); })
        .def_property_readonly(
            "outputs", [](const CaseObject& object) { return list_of(interface_of(object.file.model).outputs); })
        .def("check", [](const CaseObject& object) { refuse_impossible(object.file); })
        .def("run", &run_case, py::arg("progress"), py::arg("threads"))
        .def("input_value", &input_value, py::arg("name"), py::arg("text"))
        .def("evaluate", &evaluate_case, py::arg("inputs"), py::arg("count"), py::arg("outputs"), py::arg("progress"),
             py::arg("threads"))
        .def("sample", &sample_case, py::arg("samples"), py::arg("method"), py::arg("seed"))
        .def(
            "fit",
            [](const CaseObject& object, const py::object& progress, int threads, std::optional<std::uint64_t> seed,
               const std::vector<std::string>& mechanisms, bool with_costly) {
                return fit_of(object.file, progress, {threads, seed, mechanisms, with_costly});
            },
            py::arg("progress"), py::arg("threads"), py::arg("seed"), py::arg("mechanisms"), py::arg("with_costly"))
        .def(
            "sensitivity",
            [](const CaseObject& object, const py::object& progress, int threads, std::optional<std::uint64_t> seed) {
                sensitivity_of(object.file);
                return study_of(object.file, progress, threads, seed);
            },
            py::arg("progress"), py::arg("threads"), py::arg("seed"));
}

}  // namespace delabole
