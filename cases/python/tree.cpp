#include "cases/python/tree.hpp"

#include <pybind11/numpy.h>

#include <string>

namespace delabole {

namespace py = pybind11;

namespace {

constexpr int deepest = 32;

// Integers that a double cannot represent exactly are read as real numbers; the range of the field then rejects them.
bool is_small_integer(const py::handle& object) {
    if (PyIndex_Check(object.ptr()) == 0) {
        return false;
    }
    int overflow = 0;
    PyLong_AsLongLongAndOverflow(py::int_(py::reinterpret_borrow<py::object>(object)).ptr(), &overflow);
    return overflow == 0;
}

Node tree_within(const py::handle& object, int depth) {
    if (depth > deepest) {
        throw py::type_error("a case is not nested deeper than " + std::to_string(deepest) + " levels");
    }
    if (py::isinstance<py::array>(object)) {
        // Asked for an integer, numpy would return only the whole part of its number.
        const py::array array = py::reinterpret_borrow<py::array>(object);
        if (array.ndim() != 0) {
            throw py::type_error("one number is needed, not an array of " + std::to_string(array.ndim()) +
                                 " dimension(s)");
        }
        return tree_within(array.attr("item")(), depth);
    }
    Node node;
    if (py::isinstance<py::dict>(object)) {
        for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(object)) {
            if (!py::isinstance<py::str>(key)) {
                throw py::type_error("keys of a case are texts");
            }
            node.entries.push_back({std::string(py::reinterpret_borrow<py::str>(key)), tree_within(value, depth + 1)});
        }
    } else if (py::isinstance<py::str>(object)) {
        node.kind = Node::Kind::text;
        node.text = std::string(py::reinterpret_borrow<py::str>(object));
    } else if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) {
        node.kind = Node::Kind::array;
        for (const py::handle element : object) {
            node.elements.push_back(tree_within(element, depth + 1));
        }
    } else if (py::isinstance<py::bool_>(object)) {
        node.kind = Node::Kind::boolean;
        node.boolean = py::cast<bool>(object);
    } else if (is_small_integer(object)) {
        node.kind = Node::Kind::integer;
        node.integer = py::cast<std::int64_t>(py::int_(py::reinterpret_borrow<py::object>(object)));
        node.real = static_cast<double>(node.integer);
    } else if (py::hasattr(object, "__float__")) {
        node.kind = Node::Kind::real;
        node.real = py::cast<double>(py::float_(py::reinterpret_borrow<py::object>(object)));
    } else {
        throw py::type_error("a case holds dictionaries, lists, texts, numbers and true or false, not " +
                             std::string(py::str(py::type::of(object).attr("__name__"))));
    }
    return node;
}

}  // namespace

Node tree_of(const py::handle& object) {
    return tree_within(object, 0);
}

py::object object_of(const Node& node) {
    switch (node.kind) {
    case Node::Kind::table: {
        py::dict table;
        for (const auto& [key, value] : node.entries) {
            table[py::str(key)] = object_of(value);
        }
        return table;
    }
    case Node::Kind::array: {
        py::list array;
        for (const Node& element : node.elements) {
            array.append(object_of(element));
        }
        return array;
    }
    case Node::Kind::integer:
        return py::int_(node.integer);
    case Node::Kind::real:
        return py::float_(node.real);
    case Node::Kind::boolean:
        return py::bool_(node.boolean);
    case Node::Kind::text:
    case Node::Kind::date:
        break;
    }
    return py::str(node.text);
}

}  // namespace delabole
