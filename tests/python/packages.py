"""SSP packages of a few FMUs, written by hand for the tests."""

from zipfile import ZipFile

NAMESPACES = " ".join(
    f'xmlns:{prefix}="http://ssp-standard.org/SSP1/SystemStructure{name}"'
    for prefix, name in (("ssd", "Description"), ("ssc", "Common"), ("ssv", "ParameterValues"))
)


def component(name, source, connectors=(), start=()):
    """A component with (name, kind) of its connectors and (name, type, value) of start values."""
    connectors = "".join(
        f'<ssd:Connector name="{name}" kind="{kind}"><ssc:Real/></ssd:Connector>'
        for name, kind in connectors
    )
    start = "".join(
        f'<ssv:Parameter name="{name}"><ssv:{kind} value="{value}"/></ssv:Parameter>'
        for name, kind, value in start
    )
    return f"""<ssd:Component name="{name}" source="{source}">
        <ssd:Connectors>{connectors}</ssd:Connectors>
        <ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>
        <ssv:ParameterSet version="1.0" name="start"><ssv:Parameters>{start}</ssv:Parameters></ssv:ParameterSet>
        </ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings></ssd:Component>"""


def connection(start, end, content=""):
    """A connection between two ends, each (component, connector)."""
    return f"""<ssd:Connection startElement="{start[0]}" startConnector="{start[1]}"
        endElement="{end[0]}" endConnector="{end[1]}">{content}</ssd:Connection>"""


def write(path, components, connections=(), fmus=()):
    """Writes a package; `fmus` maps names in the package to files."""
    connections = "".join(connections)
    connections = connections and f"<ssd:Connections>{connections}</ssd:Connections>"
    text = f"""<?xml version="1.0" encoding="UTF-8"?>
        <ssd:SystemStructureDescription {NAMESPACES} version="1.0" name="test">
        <ssd:System name="test"><ssd:Elements>{"".join(components)}</ssd:Elements>
        {connections}</ssd:System></ssd:SystemStructureDescription>"""
    with ZipFile(path, "w") as package:
        package.writestr("SystemStructure.ssd", text)
        for name, file in dict(fmus).items():
            package.write(file, name)
    return path
