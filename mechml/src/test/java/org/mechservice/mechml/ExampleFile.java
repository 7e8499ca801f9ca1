package org.mechservice.mechml;

import java.io.InputStream;
import java.io.StringReader;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.transform.TransformerFactory;
import javax.xml.transform.dom.DOMSource;
import javax.xml.transform.stream.StreamResult;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.InputSource;

/** The guide's complete example, to which its shorter ones are added. */
record ExampleFile(String text) {
  private static final List<String> MODEL_ORDER =
      List.of(
          "Parameters",
          "Tables",
          "Bodies",
          "Joints",
          "Constraints",
          "States",
          "Forces",
          "Outputs",
          "topology");

  private static final Map<String, String> CONTAINERS =
      Map.ofEntries(
          Map.entry("parameter", "Parameters"),
          Map.entry("body", "Bodies"),
          Map.entry("joint", "Joints"),
          Map.entry("DISTConstraint", "Constraints"),
          Map.entry("CoordConstraint", "Constraints"),
          Map.entry("PointOnPlane", "Constraints"),
          Map.entry("PointOnLine", "Constraints"),
          Map.entry("Rolling", "Constraints"),
          Map.entry("KnifeEdge", "Constraints"),
          Map.entry("Rope", "Constraints"),
          Map.entry("JointConstraint", "Constraints"),
          Map.entry("table", "Tables"),
          Map.entry("map", "Tables"),
          Map.entry("state", "States"),
          Map.entry("pid", "States"),
          Map.entry("transferFunction", "States"),
          Map.entry("input", "States"),
          Map.entry("sampled", "States"),
          Map.entry("output", "Outputs"),
          Map.entry("root", "topology"),
          Map.entry("jointVal", "relCoorVals"),
          Map.entry("event", "dynamic"),
          Map.entry("include", "MBSmodel"),
          Map.entry("included", "MechML"),
          Map.entry("MBSsimulation", "MechML"));

  /** Returns the file with elements added, each in the place of one of the same kind and name. */
  String with(String part) {
    try {
      Document file = parse(text.substring(text.indexOf("<MechML>")));
      boolean first = true;
      for (Element added : elements(parse("<part>" + part + "</part>").getDocumentElement())) {
        put(file, (Element) file.importNode(added, true), first);
        first = false;
      }
      StringWriter writer = new StringWriter();
      TransformerFactory.newInstance()
          .newTransformer()
          .transform(new DOMSource(file), new StreamResult(writer));
      return writer.toString();
    } catch (Exception e) {
      throw new IllegalStateException(part, e);
    }
  }

  private static Document parse(String xml) throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new InputSource(new StringReader(xml)));
  }

  /** Returns the root of a file; its grammar is not looked for. */
  static Element parse(InputStream xml) throws Exception {
    try (xml) {
      DocumentBuilder builder = DocumentBuilderFactory.newInstance().newDocumentBuilder();
      builder.setEntityResolver((name, place) -> new InputSource(new StringReader("")));
      return builder.parse(xml).getDocumentElement();
    }
  }

  private static List<Element> elements(Element parent) {
    List<Element> elements = new ArrayList<>();
    for (Node n = parent.getFirstChild(); n != null; n = n.getNextSibling()) {
      if (n instanceof Element element) {
        elements.add(element);
      }
    }
    return elements;
  }

  private static void put(Document file, Element added, boolean first) {
    Element container = container(file, CONTAINERS.getOrDefault(added.getTagName(), "Forces"));
    if (added.getTagName().equals("joint")) {
      forgetStart(file, added.getAttribute("name"));
    }
    Element old = null;
    for (Element sibling : elements(container)) {
      boolean sameKind = sibling.getTagName().equals(added.getTagName());
      boolean sameName = sibling.getAttribute("name").equals(added.getAttribute("name"));
      if (sameKind && (sameName || (first && added.getTagName().equals("MBSsimulation")))) {
        old = sibling;
      }
    }
    if (old != null) {
      container.replaceChild(added, old);
    } else if (added.getTagName().equals("MBSsimulation")) {
      container.insertBefore(added, container(file, "MBSmodel"));
    } else if (added.getTagName().equals("include")) {
      container.insertBefore(added, container(file, "Bodies"));
    } else {
      container.appendChild(added);
    }
  }

  /** A joint of another type starts otherwise. */
  private static void forgetStart(Document file, String joint) {
    for (Element start : elements(container(file, "relCoorVals"))) {
      if (start.getAttribute("name").equals(joint)) {
        start.getParentNode().removeChild(start);
      }
    }
  }

  private static Element container(Document file, String name) {
    Node found = file.getElementsByTagName(name).item(0);
    if (found instanceof Element element) {
      return element;
    }
    Element model = (Element) file.getElementsByTagName("MBSmodel").item(0);
    Element container = file.createElement(name);
    for (Element section : elements(model)) {
      if (MODEL_ORDER.indexOf(section.getTagName()) > MODEL_ORDER.indexOf(name)) {
        model.insertBefore(container, section);
        return container;
      }
    }
    throw new IllegalStateException(name);
  }
}
