package org.mechservice.robot;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Content;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A model of MuJoCo as its file means it: the included files stand in their places, and every
 * element has the attributes of its default class. An element takes what it lacks from its class,
 * else from the class that the bodies around it name, else from the outermost one; a class takes
 * what it lacks from the classes around it.
 *
 * <p>Source: MuJoCo documentation, "Default settings" and {@code include}.
 *
 * @param root the element mujoco without its defaults
 * @param folder of the file
 */
record MjcfFile(Element root, Path folder) {
  private static final String MAIN = "main";

  /** Ways to write an orientation: one of an element takes the place of another of its class. */
  private static final List<String> ORIENTATIONS =
      List.of("quat", "axisangle", "euler", "xyaxes", "zaxis");

  private static final Set<String> OF_BODY = Set.of("joint", "geom", "site", "camera", "light");
  private static final Set<String> OF_ASSET = Set.of("mesh", "material", "texture");

  /**
   * Reads a model.
   *
   * @param mujoco the outermost element of its file
   */
  static MjcfFile of(
      Element mujoco, RobotFiles files, Path folder, Diagnostics diagnostics, ImportLosses losses) {
    Element whole = new Includes(files, folder, diagnostics).put(mujoco);
    FormatTable.of(RobotFormat.MJCF).checkNames(whole, diagnostics, losses);
    new MjcfRules(new RobotNumbers(diagnostics)).checkWritten(whole);
    return new MjcfFile(new Defaults(whole, diagnostics).applied(whole), folder);
  }

  /** Returns the sections of a name together: a file may have each of them several times. */
  List<Element> all(String section) {
    return root.children(section).stream().flatMap(one -> one.children().stream()).toList();
  }

  private static Element with(Element element, List<Attribute> attributes, List<Content> content) {
    return new Element(element.name(), attributes, content, element.position(), element.owner());
  }

  /** Puts included files in their places; each may be included once, as in MuJoCo. */
  private static final class Includes {
    private final RobotFiles files;
    private final Path folder;
    private final Diagnostics diagnostics;
    private final Set<String> taken = new HashSet<>();

    Includes(RobotFiles files, Path folder, Diagnostics diagnostics) {
      this.files = files;
      this.folder = folder;
      this.diagnostics = diagnostics;
    }

    Element put(Element element) {
      List<Content> content = new ArrayList<>();
      for (Content part : element.content()) {
        if (part instanceof Element child && child.name().equals("include")) {
          included(child).forEach(content::add);
        } else {
          content.add(part instanceof Element child ? put(child) : part);
        }
      }
      return with(element, element.attributes(), content);
    }

    private List<Element> included(Element include) {
      Optional<String> name = include.attribute("file");
      if (name.isEmpty() || !taken.add(name.get())) {
        diagnostics.error(
            MessageCode.ROBOT_FILE,
            include.position(),
            name.isEmpty()
                ? "include lacks its attribute file"
                : Phrase.of(
                    "the file %s is included twice; MuJoCo includes a file once",
                    Quoted.of(name.get())));
        return List.of();
      }
      return files
          .read(include, name.get(), folder, diagnostics)
          .map(root -> put(root).children())
          .orElse(List.of());
    }
  }

  /** Lists of numbers of which an element may have the first alone. */
  private static final Set<String> LISTS = Set.of("gainprm", "biasprm", "dynprm", "gear");

  /** The default classes of a file. */
  private static final class Defaults {
    private final Diagnostics diagnostics;

    /** Attributes by class and element. */
    private final Map<String, Map<String, Map<String, String>>> classes = new HashMap<>();

    Defaults(Element mujoco, Diagnostics diagnostics) {
      this.diagnostics = diagnostics;
      classes.put(MAIN, new HashMap<>());
      for (Element section : mujoco.children("default")) {
        read(section, MAIN, true);
        // Older files name the outermost class.
        section
            .attribute("class")
            .ifPresent(name -> classes.put(name, classes.getOrDefault(MAIN, Map.of())));
      }
    }

    private void read(Element section, String outer, boolean outermost) {
      String name = outermost ? MAIN : section.attribute("class").orElse(MAIN);
      Map<String, Map<String, String>> own = classes.computeIfAbsent(name, key -> new HashMap<>());
      classes.getOrDefault(outer, Map.of()).forEach((tag, values) -> inherit(own, tag, values));
      // Own values first, then the classes inside, which take what they lack from here.
      for (Element part : section.children()) {
        if (!part.name().equals("default")) {
          Map<String, String> values = own.computeIfAbsent(part.name(), key -> new HashMap<>());
          for (Attribute attribute : part.attributes()) {
            if (ORIENTATIONS.contains(attribute.name())) {
              ORIENTATIONS.forEach(values::remove);
            }
            values.merge(
                attribute.name(),
                attribute.value(),
                (known, value) -> overlaid(attribute.name(), value, known));
          }
        }
      }
      section.children("default").forEach(inner -> read(inner, name, false));
    }

    private static void inherit(
        Map<String, Map<String, String>> own, String tag, Map<String, String> values) {
      Map<String, String> kept = own.computeIfAbsent(tag, key -> new HashMap<>());
      values.forEach(
          (name, value) -> kept.merge(name, value, (known, other) -> overlaid(name, known, other)));
    }

    /** Returns the numbers of an element, and behind them those that its class has more. */
    private static String overlaid(String name, String own, String ofClass) {
      if (!LISTS.contains(name)) {
        return own;
      }
      List<String> all = new ArrayList<>(List.of(own.strip().split("\\s+", -1)));
      List<String> more = List.of(ofClass.strip().split("\\s+", -1));
      if (all.size() < more.size()) {
        all.addAll(more.subList(all.size(), more.size()));
      }
      return String.join(" ", all);
    }

    /** Returns the file without its sections default, with their values in the elements. */
    Element applied(Element mujoco) {
      List<Content> sections = new ArrayList<>();
      for (Element section : mujoco.children()) {
        if (section.name().equals("default")) {
          continue;
        }
        sections.add(
            section.name().equals("worldbody")
                ? body(section, Optional.empty())
                : with(
                    section,
                    section.attributes(),
                    section.children().stream()
                        .<Content>map(part -> part(section.name(), part))
                        .toList()));
      }
      return with(mujoco, mujoco.attributes(), sections);
    }

    private Element part(String section, Element part) {
      return switch (section) {
        case "equality" -> full(part, List.of("equality"), Optional.empty());
        case "tendon" -> full(part, List.of("tendon"), Optional.empty());
        case "actuator" -> full(part, List.of(part.name(), "general"), Optional.empty());
        case "asset" ->
            OF_ASSET.contains(part.name())
                ? full(part, List.of(part.name()), Optional.empty())
                : part;
        default -> part;
      };
    }

    private Element body(Element body, Optional<String> inherited) {
      Optional<String> childClass = childClass(body, inherited);
      List<Content> content = new ArrayList<>();
      for (Element part : body.children()) {
        if (OF_BODY.contains(part.name())) {
          content.add(full(part, List.of(part.name()), childClass));
        } else {
          content.add(
              Set.of("body", "frame", "replicate").contains(part.name())
                  ? body(part, childClass)
                  : part);
        }
      }
      return with(body, body.attributes(), content);
    }

    private Optional<String> childClass(Element element, Optional<String> outer) {
      Optional<String> own = element.attribute("childclass");
      own.ifPresent(name -> requireClass(element, name));
      return own.or(() -> outer);
    }

    private void requireClass(Element element, String name) {
      if (!classes.containsKey(name)) {
        diagnostics.error(
            MessageCode.UNKNOWN_NAME,
            element.position(),
            Phrase.of(
                "%s: default class %s does not exist%s",
                element.label(), Quoted.of(name), NearestName.suggestion(name, classes.keySet())));
      }
    }

    /** Returns an element with the values of its class. */
    private Element full(Element element, List<String> tags, Optional<String> childClass) {
      Optional<String> own = element.attribute("class");
      own.ifPresent(name -> requireClass(element, name));
      Map<String, Map<String, String>> values =
          classes.getOrDefault(own.or(() -> childClass).orElse(MAIN), Map.of());
      Map<String, String> merged = new LinkedHashMap<>();
      element.attributes().forEach(a -> merged.put(a.name(), a.value()));
      boolean turned = ORIENTATIONS.stream().anyMatch(merged::containsKey);
      boolean ended = merged.containsKey("fromto");
      for (String tag : tags) {
        values
            .getOrDefault(tag, Map.of())
            .forEach(
                (name, value) -> {
                  if (!(turned && (ORIENTATIONS.contains(name) || name.equals("fromto")))
                      && !(ended && (ORIENTATIONS.contains(name) || name.equals("pos")))) {
                    merged.merge(name, value, (own0, more) -> overlaid(name, own0, more));
                  }
                });
      }
      List<Attribute> attributes =
          merged.entrySet().stream().map(e -> new Attribute(e.getKey(), e.getValue())).toList();
      return with(element, attributes, element.content());
    }
  }
}
