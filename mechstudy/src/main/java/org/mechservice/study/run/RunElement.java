package org.mechservice.study.run;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;

/**
 * Reads how the runs of a study differ from what the model file says. Names and values of the
 * attributes are those of the service's options, so that hosts take them as they are.
 */
final class RunElement {
  static final Set<String> ATTRIBUTES =
      Set.of(
          "formulation",
          "closure",
          "integrator",
          "rtol",
          "atol",
          "accuracy",
          "t-end",
          "t-step",
          "columns");

  private RunElement() {}

  /**
   * Returns a model with other settings.
   *
   * @throws StudyRefusal if one cannot be used; says which and why
   */
  static MechModel applied(Element run, MechModel model) throws StudyRefusal {
    MechModel with = interval(run, tolerances(run, model));
    if (run.attribute("formulation").isPresent()) {
      with = with.formulation(text(run, "formulation"));
    }
    if (run.attribute("closure").isPresent()) {
      with = with.closure(text(run, "closure"));
    }
    if (run.attribute("integrator").isPresent()) {
      with = with.integrator(text(run, "integrator"));
    }
    if (run.attribute("columns").isPresent()) {
      with = with.columns(groups(text(run, "columns")));
    }
    try {
      if (run.attribute("accuracy").isPresent()) {
        with = with.accuracy(text(run, "accuracy"));
      }
      with.instances();
    } catch (IllegalArgumentException e) {
      throw new StudyRefusal(String.valueOf(e.getMessage()));
    }
    return with;
  }

  private static String text(Element run, String attribute) {
    return run.attribute(attribute).map(String::strip).orElse("");
  }

  private static MechModel interval(Element run, MechModel model) throws StudyRefusal {
    RunSettings ofFile = model.content().settings().run();
    MechModel with = model;
    if (run.attribute("t-end").isPresent()) {
      double end = StudyValue.number(run, "t-end");
      if (end < ofFile.tStart()) {
        throw new StudyRefusal(
            "t-end is " + end + " s, before the start of the run at " + ofFile.tStart() + " s");
      }
      with = with.until(end);
    }
    return run.attribute("t-step").isPresent() ? with.every(positive(run, "t-step")) : with;
  }

  private static MechModel tolerances(Element run, MechModel model) throws StudyRefusal {
    RunSettings ofFile = model.content().settings().run();
    double relative = ofFile.relativeTolerance();
    if (run.attribute("rtol").isPresent()) {
      relative = positive(run, "rtol");
      if (relative >= 1) {
        throw new StudyRefusal("rtol is " + relative + "; it must be below 1");
      }
    }
    double[] absolute = {
      ofFile.absoluteTolerance(),
      ofFile.angleTolerance(),
      ofFile.velocityTolerance(),
      ofFile.angularVelocityTolerance()
    };
    if (run.attribute("atol").isPresent()) {
      String[] words = text(run, "atol").split(";", -1);
      absolute = new double[words.length];
      for (int i = 0; i < words.length; i++) {
        absolute[i] = StudyValue.positive(words[i], "atol");
      }
      if (absolute.length != 1 && absolute.length != 4) {
        throw new StudyRefusal(
            "atol is \""
                + text(run, "atol")
                + "\"; it takes one number, or four for positions, angles, velocities and angular"
                + " velocities");
      }
    }
    return run.attribute("rtol").isPresent() || run.attribute("atol").isPresent()
        ? model.tolerances(relative, absolute)
        : model;
  }

  private static double positive(Element run, String attribute) throws StudyRefusal {
    return StudyValue.positive(text(run, attribute), attribute);
  }

  private static ColumnGroup[] groups(String text) throws StudyRefusal {
    if (text.equals("all")) {
      return ColumnGroup.values();
    }
    List<String> words = Arrays.stream(text.split(",", -1)).map(String::strip).toList();
    List<String> known = Stream.of(ColumnGroup.values()).map(ColumnGroup::label).toList();
    for (String word : words) {
      if (!known.contains(word)) {
        throw new StudyRefusal(
            "columns names \""
                + word
                + "\", which is no column group"
                + NearestName.suggestion(word, known)
                + "; there are "
                + known.stream().collect(Collectors.joining(", "))
                + " and all");
      }
    }
    return Stream.of(ColumnGroup.values())
        .filter(group -> words.contains(group.label()))
        .toArray(ColumnGroup[]::new);
  }
}
