package org.mechservice.robot;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Content;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Puts included models of SDF in the places of their elements {@code include}, which may give them
 * another name, pose, placement frame, and rest. Source: the specification sdformat 1.12, {@code
 * include}, and "Model composition".
 */
final class SdfIncludes {
  /** Files within each other; more are a circle. */
  private static final int DEEPEST = 50;

  private final RobotFiles files;
  private final Diagnostics diagnostics;
  private int depth;

  SdfIncludes(RobotFiles files, Diagnostics diagnostics) {
    this.files = files;
    this.diagnostics = diagnostics;
  }

  /**
   * Returns an element with the models in place of their includes.
   *
   * @param folder of the file that the element is of
   */
  Element put(Element element, Path folder) {
    List<Content> content = new ArrayList<>();
    for (Content part : element.content()) {
      if (!(part instanceof Element child)) {
        content.add(part);
      } else if (child.name().equals("include")) {
        model(child, folder).ifPresent(content::add);
      } else {
        content.add(put(child, folder));
      }
    }
    return new Element(
        element.name(), element.attributes(), content, element.position(), element.owner());
  }

  private Optional<Element> model(Element include, Path folder) {
    String uri = include.child("uri").map(Element::text).orElse("");
    if (include.attribute("merge").filter(m -> m.equals("true") || m.equals("1")).isPresent()) {
      error(include, "it merges the model %s into this one; write its parts here instead", uri);
      return Optional.empty();
    }
    Optional<Path> found = files.find(uri, folder).flatMap(this::modelFile);
    if (found.isEmpty()) {
      files.missing(include, uri, diagnostics);
      return Optional.empty();
    }
    if (++depth > DEEPEST) {
      error(include, "the model %s includes itself", uri);
      return Optional.empty();
    }
    Optional<Element> model =
        files
            .read(include, found.get(), diagnostics)
            .flatMap(
                root -> {
                  Optional<Element> one = root.child("model");
                  if (one.isEmpty()) {
                    error(include, "the file %s holds no model", uri);
                  }
                  return one;
                })
            .map(one -> put(one, Objects.requireNonNullElse(found.get().getParent(), Path.of(""))))
            .map(one -> overridden(one, include));
    depth--;
    return model;
  }

  private void error(Element include, String format, String uri) {
    diagnostics.error(
        MessageCode.ROBOT_FILE,
        include.position(),
        include.label() + ": " + Phrase.of(format, Quoted.of(uri)));
  }

  /** Returns the file of a model, which may be a folder whose model.config names it. */
  private Optional<Path> modelFile(Path found) {
    if (!Files.isDirectory(found)) {
      return Optional.of(found);
    }
    Path config = found.resolve("model.config");
    if (Files.isRegularFile(config)) {
      Diagnostics own = new Diagnostics(config.toString());
      Element none = new Element("model", List.of(), List.of(), SourcePosition.FILE, "");
      // The last entry is that of the newest version of SDF.
      Optional<String> name =
          files
              .read(none, config, own)
              .flatMap(
                  root ->
                      root.children("sdf").stream()
                          .reduce((earlier, later) -> later)
                          .map(Element::text));
      if (name.isPresent()) {
        return Optional.of(found.resolve(name.get()));
      }
    }
    Path usual = found.resolve("model.sdf");
    return Files.isRegularFile(usual) ? Optional.of(usual) : Optional.empty();
  }

  private static Element overridden(Element model, Element include) {
    List<Attribute> attributes = new ArrayList<>(model.attributes());
    replace(attributes, "name", include.child("name").map(Element::text));
    replace(attributes, "placement_frame", include.child("placement_frame").map(Element::text));
    List<Content> content = new ArrayList<>();
    for (Content part : model.content()) {
      boolean replaced =
          part instanceof Element child
              && List.of("pose", "static").contains(child.name())
              && include.child(child.name()).isPresent();
      if (!replaced) {
        content.add(part);
      }
    }
    include.child("pose").ifPresent(content::add);
    include.child("static").ifPresent(content::add);
    return new Element("model", attributes, content, model.position(), include.owner());
  }

  private static void replace(List<Attribute> attributes, String name, Optional<String> value) {
    value
        .filter(text -> !text.isEmpty())
        .ifPresent(
            text -> {
              attributes.removeIf(attribute -> attribute.name().equals(name));
              attributes.add(new Attribute(name, text));
            });
  }
}
