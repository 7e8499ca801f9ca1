package org.mechservice.sim.packaging;

import java.util.List;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.StateVariable;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.text.ShortestDecimal;

/** {@code META-INF/modelDescription.xml}: the contents of a model JAR, for readers and tools. */
public final class ModelDescriptionXml {
  private final StringBuilder xml = new StringBuilder();

  private ModelDescriptionXml() {}

  /**
   * Describes a model; its origin and its omitted parts are in the manifest.
   *
   * @param description name, joints, default settings
   * @param start state at the start, [q; v]; not modified
   * @return the text of the file
   */
  public static String of(ModelDescription description, double[] start) {
    ModelDescriptionXml file = new ModelDescriptionXml();
    file.xml.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<modelDescription");
    file.attribute("name", description.name())
        .attribute("formulation", description.formulation())
        .attribute("apiVersion", Integer.toString(Model.API_VERSION));
    file.xml.append(">\n");
    file.settings(description.defaults());
    file.joints(description, start);
    file.xml.append("</modelDescription>\n");
    return file.xml.toString();
  }

  private void settings(RunSettings settings) {
    xml.append("  <settings");
    attribute("tStart", settings.tStart())
        .attribute("tEnd", settings.tEnd())
        .attribute("tStep", settings.tStep())
        .attribute("integrator", settings.integrator())
        .attribute("relativeTolerance", settings.relativeTolerance())
        .attribute("absoluteTolerance", settings.absoluteTolerance());
    if (Double.isFinite(settings.maxStep())) {
      attribute("maxStep", settings.maxStep());
    }
    if (settings.initialStep() != 0) {
      attribute("initialStep", settings.initialStep());
    }
    if (settings.maxOrder() != 0) {
      attribute("maxOrder", Integer.toString(settings.maxOrder()));
    }
    if (settings.accuracy() != Accuracy.STANDARD) {
      attribute(Accuracy.OPTION, settings.accuracy().label());
    }
    close();
  }

  /** Writes the joints; the name of a result column is {@code joint.variable}. */
  private void joints(ModelDescription description, double[] start) {
    List<Variable> states = description.states();
    List<Variable> accelerations = description.accelerations();
    int position = 0;
    int velocity = 0;
    int positions = description.positionCount();
    for (JointVariables joint : description.joints()) {
      xml.append("  <joint");
      attribute("name", joint.name()).attribute("type", joint.type().name());
      xml.append(">");
      for (int i = 0; i < joint.type().positionCount(); i++, position++) {
        variable("state", joint, states.get(position)).start(start[position]);
      }
      for (int i = 0; i < joint.type().velocityCount(); i++) {
        int at = positions + velocity + i;
        variable("state", joint, states.get(at)).start(start[at]);
      }
      for (int i = 0; i < joint.type().velocityCount(); i++, velocity++) {
        variable("output", joint, accelerations.get(velocity));
        xml.append("/>");
      }
      xml.append("</joint>\n");
    }
    int further = positions + description.velocityCount();
    for (StateVariable state : description.furtherStates()) {
      xml.append("  <state");
      attribute("name", state.name())
          .attribute("unit", state.unit())
          .attribute("start", start[further++]);
      close();
    }
  }

  private ModelDescriptionXml variable(String kind, JointVariables joint, Variable variable) {
    xml.append('<').append(kind);
    return attribute("name", variable.name().substring(joint.name().length() + 1))
        .attribute("unit", variable.unit());
  }

  private void start(double value) {
    attribute("start", value);
    xml.append("/>");
  }

  private void close() {
    xml.append("/>\n");
  }

  private ModelDescriptionXml attribute(String name, double value) {
    return attribute(name, ShortestDecimal.format(value));
  }

  private ModelDescriptionXml attribute(String name, String value) {
    xml.append(' ').append(name).append("=\"");
    value.codePoints().forEach(this::character);
    xml.append('"');
    return this;
  }

  /** Writes a character; one that XML 1.0 does not permit becomes a question mark. */
  private void character(int c) {
    switch (c) {
      case '&' -> xml.append("&amp;");
      case '<' -> xml.append("&lt;");
      case '>' -> xml.append("&gt;");
      case '"' -> xml.append("&quot;");
      default -> {
        boolean surrogate = c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE;
        boolean legal = c >= ' ' && !surrogate && c != 0xFFFE && c != 0xFFFF;
        xml.appendCodePoint(legal ? c : '?');
      }
    }
  }
}
