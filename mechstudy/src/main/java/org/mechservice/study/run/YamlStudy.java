package org.mechservice.study.run;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.api.lowlevel.Compose;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;

/**
 * Reads a study in YAML as the elements of the same study in XML, at the lines and columns of the
 * YAML file: a mapping is an element, its plain values are attributes, and lists {@code factors},
 * {@code tables} and {@code outputs} have an element for each item. A list of plain values, such as
 * {@code values: [1, 2, 5]}, is an attribute with spaces between.
 */
final class YamlStudy {
  /** Lists of elements with the name of each element. */
  private static final Map<String, String> LISTS =
      Map.of("factors", "factor", "tables", "table", "outputs", "output");

  private final Diagnostics diagnostics;

  private YamlStudy(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  /**
   * Reads a file.
   *
   * @param content UTF-8
   * @return an element {@code study}
   * @throws MechmlException if it is no YAML, or no mapping
   */
  static Element read(byte[] content, Diagnostics diagnostics) throws MechmlException {
    return new YamlStudy(diagnostics).read(content);
  }

  private Element read(byte[] content) throws MechmlException {
    Optional<Node> root = Optional.empty();
    try {
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(content)).toString();
      root = new Compose(LoadSettings.builder().build()).composeString(text);
    } catch (CharacterCodingException e) {
      error(SourcePosition.FILE, "the file is not UTF-8");
    } catch (MarkedYamlEngineException e) {
      error(position(e.getProblemMark()), "this is no YAML: " + e.getProblem());
    } catch (YamlEngineException e) {
      error(SourcePosition.FILE, "this is no YAML: " + e.getMessage());
    }
    Element study = new Element("study", List.of(), List.of(), new SourcePosition(1, 1, ""), "");
    if (root.isPresent() && root.get() instanceof MappingNode mapping) {
      study = element("study", mapping, true);
    } else if (!diagnostics.hasErrors()) {
      error(
          new SourcePosition(1, 1, ""),
          "a study is a mapping with model, factors, design and outputs, such as model: seat.xml");
    }
    diagnostics.throwIfErrors();
    return study;
  }

  private void error(SourcePosition at, String message) {
    diagnostics.error(MessageCode.STUDY_UNUSABLE, at, message);
  }

  private static SourcePosition position(Optional<Mark> mark) {
    return mark.map(m -> new SourcePosition(m.getLine() + 1, m.getColumn() + 1, ""))
        .orElse(SourcePosition.FILE);
  }

  private Element element(String name, MappingNode mapping, boolean isRoot) {
    List<Attribute> attributes = new ArrayList<>();
    List<Element> children = new ArrayList<>();
    Set<String> taken = new HashSet<>();
    for (NodeTuple entry : mapping.getValue()) {
      Node value = entry.getValueNode();
      SourcePosition at = position(entry.getKeyNode().getStartMark());
      if (!(entry.getKeyNode() instanceof ScalarNode scalar)) {
        error(at, "a name is expected here, such as factors");
        continue;
      }
      String key = scalar.getValue();
      if (!taken.add(key)) {
        error(at, key + " is given twice");
      } else if (isRoot && LISTS.containsKey(key)) {
        addAll(LISTS.get(key), key, value, children);
      } else if (value instanceof MappingNode inner) {
        children.add(element(key, inner, false));
      } else if (plain(value).isPresent()) {
        attributes.add(new Attribute(key, plain(value).get()));
      } else {
        error(at, key + " has a list in a list, which a study has nowhere");
      }
    }
    return new Element(
        name, attributes, List.copyOf(children), position(mapping.getStartMark()), "");
  }

  private void addAll(String name, String key, Node value, List<Element> children) {
    if (!(value instanceof SequenceNode items)) {
      error(
          position(value.getStartMark()),
          key + " is a list: write each " + name + " on a line that begins with a dash");
      return;
    }
    for (Node item : items.getValue()) {
      if (item instanceof MappingNode mapping) {
        children.add(element(name, mapping, false));
      } else {
        error(
            position(item.getStartMark()),
            "a " + name + " is a mapping, such as {" + example(name) + "}");
      }
    }
  }

  private static String example(String name) {
    return switch (name) {
      case "factor" -> "name: damping, from: 500, to: 4500";
      case "table" -> "file: points.csv";
      default -> "of: max(height.q)";
    };
  }

  /** Returns a plain value as it is written, or a list of such with spaces between. */
  private static Optional<String> plain(Node value) {
    if (value instanceof ScalarNode scalar) {
      return Optional.of(scalar.getValue());
    } else if (value instanceof SequenceNode items
        && items.getValue().stream().allMatch(ScalarNode.class::isInstance)) {
      return Optional.of(
          items.getValue().stream()
              .map(item -> ((ScalarNode) item).getValue())
              .collect(Collectors.joining(" ")));
    }
    return Optional.empty();
  }
}
