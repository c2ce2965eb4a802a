//! The elements of a modelDescription.xml and their attributes: the schema of FMI 2.0 as data
//! (§2.2, fmi2ModelDescription.xsd).

use super::description::KINDS;
use super::grammar::Value::{
    Boolean, DateTime, Integer, Real, Text, Unsigned, UnsignedList, Word, WordList,
};
use super::grammar::{Schema, any_number, leaf, may, must, one, optional, some, tree};

/// The whole description.
pub const ROOT: Schema = tree(
    "fmiModelDescription",
    &[
        must("fmiVersion", Text),
        must("modelName", Text),
        must("guid", Text),
        may("description", Text),
        may("author", Text),
        may("version", Text),
        may("copyright", Text),
        may("license", Text),
        may("generationTool", Text),
        may("generationDateAndTime", DateTime),
        may("variableNamingConvention", Word(&["flat", "structured"])),
        may("numberOfEventIndicators", Unsigned),
    ],
    &[
        optional(&[MODEL_EXCHANGE]),
        optional(&[CO_SIMULATION]),
        optional(&[tree("UnitDefinitions", &[], &[some(&[UNIT])])]),
        optional(&[tree("TypeDefinitions", &[], &[some(&[SIMPLE_TYPE])])]),
        optional(&[tree("LogCategories", &[], &[some(&[CATEGORY])])]),
        optional(&[DEFAULT_EXPERIMENT]),
        optional(&[tree("VendorAnnotations", &[], &[any_number(&[TOOL])])]),
        one(&[tree("ModelVariables", &[], &[some(&[SCALAR_VARIABLE])])]),
        one(&[tree(
            "ModelStructure",
            &[],
            &[
                optional(&[tree("Outputs", &[], &[some(&[UNKNOWN])])]),
                optional(&[tree("Derivatives", &[], &[some(&[UNKNOWN])])]),
                optional(&[tree("InitialUnknowns", &[], &[some(&[UNKNOWN])])]),
            ],
        )]),
    ],
);

const MODEL_EXCHANGE: Schema = tree(
    "ModelExchange",
    &[
        must("modelIdentifier", Text),
        may("needsExecutionTool", Boolean),
        may("completedIntegratorStepNotNeeded", Boolean),
        may("canBeInstantiatedOnlyOncePerProcess", Boolean),
        may("canNotUseMemoryManagementFunctions", Boolean),
        may("canGetAndSetFMUstate", Boolean),
        may("canSerializeFMUstate", Boolean),
        may("providesDirectionalDerivative", Boolean),
    ],
    &[optional(&[SOURCE_FILES])],
);

const CO_SIMULATION: Schema = tree(
    "CoSimulation",
    &[
        must("modelIdentifier", Text),
        may("needsExecutionTool", Boolean),
        may("canHandleVariableCommunicationStepSize", Boolean),
        may("canInterpolateInputs", Boolean),
        may("maxOutputDerivativeOrder", Unsigned),
        may("canRunAsynchronuously", Boolean),
        may("canBeInstantiatedOnlyOncePerProcess", Boolean),
        may("canNotUseMemoryManagementFunctions", Boolean),
        may("canGetAndSetFMUstate", Boolean),
        may("canSerializeFMUstate", Boolean),
        may("providesDirectionalDerivative", Boolean),
    ],
    &[optional(&[SOURCE_FILES])],
);

const SOURCE_FILES: Schema =
    tree("SourceFiles", &[], &[some(&[leaf("File", &[must("name", Text)])])]);

const UNIT: Schema = tree(
    "Unit",
    &[must("name", Text)],
    &[
        optional(&[leaf(
            "BaseUnit",
            &[
                may("kg", Integer),
                may("m", Integer),
                may("s", Integer),
                may("A", Integer),
                may("K", Integer),
                may("mol", Integer),
                may("cd", Integer),
                may("rad", Integer),
                may("factor", Real),
                may("offset", Real),
            ],
        )]),
        any_number(&[leaf(
            "DisplayUnit",
            &[must("name", Text), may("factor", Real), may("offset", Real)],
        )]),
    ],
);

const SIMPLE_TYPE: Schema = tree(
    "SimpleType",
    &[must("name", Text), may("description", Text)],
    &[one(&[
        leaf(
            KINDS[0],
            &[
                may("quantity", Text),
                may("unit", Text),
                may("displayUnit", Text),
                may("relativeQuantity", Boolean),
                may("min", Real),
                may("max", Real),
                may("nominal", Real),
                may("unbounded", Boolean),
            ],
        ),
        leaf(KINDS[1], &[may("quantity", Text), may("min", Integer), may("max", Integer)]),
        leaf(KINDS[2], &[]),
        leaf(KINDS[3], &[]),
        tree(
            KINDS[4],
            &[may("quantity", Text)],
            &[some(&[leaf(
                "Item",
                &[must("name", Text), must("value", Integer), may("description", Text)],
            )])],
        ),
    ])],
);

const CATEGORY: Schema = leaf("Category", &[must("name", Text), may("description", Text)]);

const DEFAULT_EXPERIMENT: Schema = leaf(
    "DefaultExperiment",
    &[may("startTime", Real), may("stopTime", Real), may("tolerance", Real), may("stepSize", Real)],
);

const TOOL: Schema = Schema { name: "Tool", attributes: &[must("name", Text)], slots: None };

const SCALAR_VARIABLE: Schema = tree(
    "ScalarVariable",
    &[
        must("name", Text),
        must("valueReference", Unsigned),
        may("description", Text),
        may(
            "causality",
            Word(&["parameter", "calculatedParameter", "input", "output", "local", "independent"]),
        ),
        may("variability", Word(&["constant", "fixed", "tunable", "discrete", "continuous"])),
        may("initial", Word(&["exact", "approx", "calculated"])),
        may("canHandleMultipleSetPerTimeInstant", Boolean),
    ],
    &[
        one(&[
            leaf(
                KINDS[0],
                &[
                    may("declaredType", Text),
                    may("quantity", Text),
                    may("unit", Text),
                    may("displayUnit", Text),
                    may("relativeQuantity", Boolean),
                    may("min", Real),
                    may("max", Real),
                    may("nominal", Real),
                    may("unbounded", Boolean),
                    may("start", Real),
                    may("derivative", Unsigned),
                    may("reinit", Boolean),
                ],
            ),
            leaf(
                KINDS[1],
                &[
                    may("declaredType", Text),
                    may("quantity", Text),
                    may("min", Integer),
                    may("max", Integer),
                    may("start", Integer),
                ],
            ),
            leaf(KINDS[2], &[may("declaredType", Text), may("start", Boolean)]),
            leaf(KINDS[3], &[may("declaredType", Text), may("start", Text)]),
            leaf(
                KINDS[4],
                &[
                    must("declaredType", Text),
                    may("quantity", Text),
                    may("min", Integer),
                    may("max", Integer),
                    may("start", Integer),
                ],
            ),
        ]),
        optional(&[tree("Annotations", &[], &[some(&[TOOL])])]),
    ],
);

const UNKNOWN: Schema = leaf(
    "Unknown",
    &[
        must("index", Unsigned),
        may("dependencies", UnsignedList),
        may(
            "dependenciesKind",
            WordList(&["dependent", "constant", "fixed", "tunable", "discrete"]),
        ),
    ],
);
