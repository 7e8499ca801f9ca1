package org.mechservice.mechml.include;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Content;
import org.mechservice.mechml.document.DocumentReader;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.document.Limits;
import org.mechservice.mechml.document.Text;
import org.mechservice.solver.catalogue.MessageCode;

/** Puts the parts of included files in the sections of a model. */
public final class IncludedParts {
  private static final String STARTS = "relCoorVals";
  private static final String TOPOLOGY = "topology";

  /** The sections of a model in the order of the grammar; the last is a part of topology. */
  private static final List<String> SECTIONS =
      List.of(
          "Parameters",
          "Tables",
          "Bodies",
          "Joints",
          "Constraints",
          "States",
          "Forces",
          "Outputs",
          STARTS);

  private static final List<String> UNITS =
      List.of("massUnits", "lengthUnits", "angleUnits", "forceUnits");

  /** Files in files; more than models of assemblies of assemblies have. */
  private static final int DEEPEST = 50;

  private static final int MOST_FILES = 1000;

  private final Element model;
  private final Map<String, String> texts = new HashMap<>();
  private final Map<String, Optional<Element>> subsystems = new HashMap<>();
  private final Deque<String> within = new ArrayDeque<>();
  private final Diagnostics diagnostics;
  private int elements;

  private IncludedParts(Element document, Diagnostics diagnostics) {
    this.model = document.requiredChild("MBSmodel");
    this.diagnostics = diagnostics;
    for (Element included : document.children("included")) {
      StringBuilder text = new StringBuilder();
      for (Content part : included.content()) {
        text.append(part instanceof Text inner ? inner.text() : "");
      }
      texts.put(included.required("file"), text.toString());
    }
  }

  /**
   * Returns a document in which the parts stand in place of the includes.
   *
   * @param document the element MechML, valid
   * @param diagnostics receives errors, those about an included file with its name
   * @throws MechmlException if a file is missing, cannot be read or includes itself
   */
  public static Element put(Element document, Diagnostics diagnostics) throws MechmlException {
    Element model = document.requiredChild("MBSmodel");
    if (model.children("include").isEmpty()) {
      return document;
    }
    IncludedParts parts = new IncludedParts(document, diagnostics);
    if (parts.texts.size() > MOST_FILES) {
      diagnostics.error(
          MessageCode.MODEL_FILE_TOO_LARGE,
          document.position(),
          "the model includes " + parts.texts.size() + " files; it may include " + MOST_FILES);
      diagnostics.throwIfErrors();
    }
    Element whole = parts.whole(model);
    diagnostics.throwIfErrors();
    List<Content> content = new ArrayList<>();
    for (Element child : document.children()) {
      if (!child.name().equals("included")) {
        content.add(child.name().equals("MBSmodel") ? whole : child);
      }
    }
    return with(document, content);
  }

  /** Returns a model or a subsystem with the parts of the files that it includes. */
  private Element whole(Element holder) {
    Map<String, List<Element>> added = new HashMap<>();
    for (Element include : holder.children("include")) {
      Optional<Element> subsystem = subsystem(include);
      if (subsystem.isPresent() && hasUnits(include, subsystem.get())) {
        add(include, subsystem.get(), added);
      }
    }
    List<Content> content = new ArrayList<>();
    for (String section : SECTIONS) {
      Optional<Element> own = holder.child(section);
      List<Element> more = added.getOrDefault(section, List.of());
      boolean inTopology = section.equals(STARTS) && holder.child(TOPOLOGY).isPresent();
      if (!inTopology && (own.isPresent() || !more.isEmpty())) {
        content.add(together(own, section, more));
      }
    }
    holder
        .child(TOPOLOGY)
        .ifPresent(
            topology -> content.add(topology(topology, added.getOrDefault(STARTS, List.of()))));
    return with(holder, content);
  }

  private void add(Element include, Element subsystem, Map<String, List<Element>> added) {
    Instance instance = new Instance(include, subsystem, diagnostics);
    for (Element section : subsystem.children()) {
      elements += section.children().size();
      if (elements > Limits.ELEMENTS) {
        error(
            MessageCode.MODEL_FILE_TOO_LARGE,
            include,
            "the included files have more than " + Limits.ELEMENTS + " elements together");
        return;
      }
      added.computeIfAbsent(section.name(), name -> new ArrayList<>()).addAll(instance.of(section));
    }
    instance.checkBindings(Instance.namesIn(subsystem));
  }

  /** Returns the outermost element of an included file with all that this includes. */
  private Optional<Element> subsystem(Element include) {
    String file = include.required("file");
    if (within.contains(file)) {
      List<String> chain = new ArrayList<>(within);
      Collections.reverse(chain);
      chain.add(file);
      return error(
          MessageCode.INCLUDED_FILE,
          include,
          "the file includes itself: " + String.join(" includes ", chain));
    }
    if (within.size() >= DEEPEST) {
      return error(
          MessageCode.INCLUDED_FILE,
          include,
          "files include each other more than " + DEEPEST + " deep");
    }
    String text = texts.get(file);
    if (text == null) {
      return error(
          MessageCode.INCLUDED_FILE,
          include,
          Phrase.of(
              "the file %s was not read, because this model is not read from a folder; append"
                  + " its text in <included file=%s>",
              Quoted.of(file), Quoted.of(file)));
    }
    Optional<Element> known = subsystems.get(file);
    if (known == null) {
      within.push(file);
      known = parsed(file, text).map(this::whole);
      within.pop();
      subsystems.put(file, known);
    }
    return known;
  }

  private Optional<Element> parsed(String file, String text) {
    try {
      Element subsystem =
          DocumentReader.readSubsystem(
              text.getBytes(StandardCharsets.UTF_8), new Diagnostics(file));
      for (Element force : subsystem.child("Forces").map(Element::children).orElse(List.of())) {
        if (force.name().equals("gravity")) {
          error(
              MessageCode.INCLUDED_FILE,
              placed(force, file),
              "gravity is one for the whole model; write it in the model file");
        }
      }
      return Optional.of(placed(subsystem, file));
    } catch (MechmlException e) {
      diagnostics.addAll(e.diagnostics());
      return Optional.empty();
    }
  }

  /** Returns an element whose positions are those in its file. */
  private static Element placed(Element element, String file) {
    List<Content> content = new ArrayList<>();
    for (Content part : element.content()) {
      content.add(part instanceof Element child ? placed(child, file) : part);
    }
    return new Element(
        element.name(),
        element.attributes(),
        content,
        element.position().in(file),
        element.owner());
  }

  private boolean hasUnits(Element include, Element subsystem) {
    for (String units : UNITS) {
      Optional<String> here = model.attribute(units);
      Optional<String> there = subsystem.attribute(units);
      if (!here.equals(there)) {
        error(
            MessageCode.INCLUDED_FILE,
            include,
            Phrase.of(
                "%s has %s, the model has %s; both must be the same",
                Quoted.of(include.required("file")), shown(units, there), shown(units, here)));
        return false;
      }
    }
    return true;
  }

  private static String shown(String units, Optional<String> value) {
    return value.map(one -> units + "=\"" + one + "\"").orElse("no " + units);
  }

  private Element topology(Element topology, List<Element> starts) {
    List<Content> content = new ArrayList<>(topology.children("root"));
    content.add(together(topology.child(STARTS), STARTS, starts));
    return with(topology, content);
  }

  private Element together(Optional<Element> own, String section, List<Element> more) {
    List<Content> content = new ArrayList<>(own.map(Element::content).orElse(List.of()));
    content.addAll(more);
    Element head =
        own.orElseGet(() -> new Element(section, List.of(), List.of(), model.position(), ""));
    return with(head, content);
  }

  private static Element with(Element element, List<Content> content) {
    return new Element(
        element.name(), element.attributes(), content, element.position(), element.owner());
  }

  private Optional<Element> error(MessageCode code, Element element, String message) {
    diagnostics.error(code, element.position(), element.label() + ": " + message);
    return Optional.empty();
  }
}
