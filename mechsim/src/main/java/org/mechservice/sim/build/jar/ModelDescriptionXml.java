package org.mechservice.sim.build.jar;

import java.util.List;
import java.util.Map;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.Variable;
import org.mechservice.solver.standalone.ShortestDecimal;

/** {@code META-INF/modelDescription.xml}: what a model JAR contains, for people and tools. */
public final class ModelDescriptionXml {
  private final StringBuilder xml = new StringBuilder();

  private ModelDescriptionXml() {}

  /**
   * Describes a model.
   *
   * @param description name, joints, default settings
   * @param start state at the start, [q; v]; not modified
   * @param outputs what else it can put out, besides accelerations
   * @param leftOut what was left out, with the reasons, in order
   * @param mechmlSha256 SHA-256 of the model file
   * @return the text of the file
   */
  public static String of(
      ModelDescription description,
      double[] start,
      List<Variable> outputs,
      Map<String, String> leftOut,
      String mechmlSha256) {
    ModelDescriptionXml file = new ModelDescriptionXml();
    file.xml.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<modelDescription");
    file.attribute("name", description.name())
        .attribute("formulation", description.formulation())
        .attribute("apiVersion", Integer.toString(Model.API_VERSION))
        .attribute("mechmlSha256", mechmlSha256);
    file.xml.append(">\n");
    file.settings(description.defaults());
    file.variables(description, start, outputs);
    file.xml.append("  <leftOut>\n");
    leftOut.forEach(
        (what, why) -> file.open("item").attribute("what", what).attribute("why", why).close());
    file.xml.append("  </leftOut>\n</modelDescription>\n");
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
    close();
  }

  private void variables(ModelDescription description, double[] start, List<Variable> outputs) {
    xml.append("  <variables>\n");
    List<Variable> states = description.states();
    for (int i = 0; i < states.size(); i++) {
      variable(states.get(i), "state").attribute("start", start[i]).close();
    }
    description.accelerations().forEach(variable -> variable(variable, "output").close());
    outputs.forEach(variable -> variable(variable, "output").close());
    xml.append("  </variables>\n");
  }

  private ModelDescriptionXml variable(Variable variable, String kind) {
    return open("variable")
        .attribute("name", variable.name())
        .attribute("unit", variable.unit())
        .attribute("kind", kind);
  }

  private ModelDescriptionXml open(String element) {
    xml.append("    <").append(element);
    return this;
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

  /** What XML 1.0 cannot hold becomes a question mark. */
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
