package org.mechservice.mechml.resolve.joint;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.JointCoordinateUnits;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.StartRole;

/** Reads the attributes {@code driven} and {@code fixed} of {@code jointVal}. */
public final class DriveReader {
  /** Axes of three turns, of which no two neighbours are equal. */
  private static final Pattern AXES = Pattern.compile("(?!(.)\\1|.(.)\\2)[xyz]{3}");

  private final FormulaReader formulas;
  private final JointCoordinateUnits units;
  private final Diagnostics diagnostics;

  public DriveReader(ValueReader values, FormulaReader formulas, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.units = new JointCoordinateUnits(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the role of a joint's start in assembly: fixed, or by what of it is given. */
  public static StartRole role(JointLink link) {
    Optional<Element> start = link.start();
    if (start.flatMap(s -> s.attribute("fixed")).map("true"::equals).orElse(false)) {
      return StartRole.FIXED;
    }
    boolean velocities = start.flatMap(s -> s.attribute("velVals")).isPresent();
    if (start.flatMap(s -> s.attribute("posVals")).isPresent()) {
      return velocities ? StartRole.PREFERRED : StartRole.PREFERRED_POSITIONS;
    }
    return velocities ? StartRole.PREFERRED_VELOCITIES : StartRole.FREE;
  }

  /**
   * Returns one expression of time per position; empty if the joint is not driven. Those of S and F
   * joints begin with a path of unit quaternions.
   *
   * @param cut whether the joint is a cut one
   */
  public List<Expression> motion(JointLink link, boolean cut) {
    if (!link.isDriven()) {
      return List.of();
    }
    Element element = link.start().orElseThrow();
    JointType type = link.type();
    boolean turns = type.hasEulerParameters();
    Optional<String> axes = element.attribute("rotation");
    if (type.positionCount() == 0) {
      return refused(element, Phrase.of("a joint of type %s has no motion", type));
    }
    if (turns && cut) {
      return refused(
          element,
          Phrase.of(
              "a joint of type %s is driven only where it is no cut; write cut=\"true\" on another"
                  + " joint of its loop",
              type));
    }
    if (axes.isPresent() && !turns) {
      return refused(
          element,
          Phrase.of("rotation is for joints of type S and F, and this one is of type %s", type));
    }
    if (axes.isPresent() && !AXES.matcher(axes.get()).matches()) {
      return refused(
          element,
          Phrase.of(
              "rotation is %s; write the axes of the three turns in their order, such as xyz or"
                  + " zxz, where neighbours differ",
              Quoted.of(axes.get())));
    }
    for (String overruled : List.of("posVals", "velVals")) {
      if (element.attribute(overruled).isPresent()) {
        diagnostics.warning(
            MessageCode.DRIVEN_JOINT,
            element.position(),
            Phrase.of(
                "%s: %s has no effect, because the attribute driven defines the motion",
                element.label(), overruled));
      }
    }
    Optional<List<Expression>> read =
        (axes.isPresent() ? units.angles(element, type) : units.positions(element, type))
            .flatMap(u -> formulas.list(element, "driven", u, FormulaRole.MOTION));
    if (!turns || read.isEmpty()) {
      return read.orElse(List.of());
    }
    List<Expression> given = read.get();
    int ofTurn = axes.isPresent() ? 3 : 4;
    List<Expression> motion =
        new ArrayList<>(
            axes.isPresent()
                ? TurningPath.ofAngles(axes.get(), given.subList(0, 3))
                : TurningPath.normalised(given.subList(0, 4)));
    motion.addAll(given.subList(ofTurn, given.size()));
    return motion;
  }

  private List<Expression> refused(Element element, String why) {
    diagnostics.error(
        MessageCode.DRIVEN_JOINT, element.position(), Phrase.of("%s: %s", element.label(), why));
    return List.of();
  }
}
