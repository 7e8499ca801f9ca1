package org.mechservice.mechml.resolve.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.JointCoordinateUnits;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.formula.ResolvedJoint;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.FurtherChange;
import org.mechservice.solver.mechanism.StateChange;

/** Reads the {@code event}s of a simulation. */
public final class EventsReader {
  private final FormulaReader formulas;
  private final JointCoordinateUnits units;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  public EventsReader(
      ValueReader values, FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.units = new JointCoordinateUnits(values, diagnostics);
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns the events without errors, in file order. */
  List<Event> read(List<Element> elements) {
    NameTable<Element> taken = new NameTable<>("event", "does not exist", diagnostics);
    List<Event> events = new ArrayList<>();
    for (Element element : elements) {
      taken.add(element, Optional.of(element));
      event(element).ifPresent(events::add);
    }
    return events;
  }

  private Optional<Event> event(Element element) {
    String action = element.required("action");
    List<Element> sets = element.children("set");
    if (action.equals("set") == sets.isEmpty()) {
      error(
          element,
          sets.isEmpty()
              ? "action is \"set\", but the event has no <set>; add one"
              : Phrase.of(
                  "action is %s, and <set> has no meaning for it; remove <set>",
                  Quoted.of(action)));
      return Optional.empty();
    }
    List<StateChange> changes = new ArrayList<>();
    List<FurtherChange> furtherChanges = new ArrayList<>();
    for (Element set : sets) {
      if (names.joint(set.required("name")).isEmpty() && isState(set)) {
        furtherChange(set).ifPresent(furtherChanges::add);
      } else {
        change(set).ifPresent(changes::add);
      }
    }
    Optional<Expression> trigger =
        formulas.read(AttributeText.of(element, "expression"), Unit.ONE, FormulaRole.STATE);
    if (trigger.isEmpty() || changes.size() + furtherChanges.size() < sets.size()) {
      return Optional.empty();
    }
    String direction = element.attribute("direction").orElse("both");
    return Optional.of(
        new Event(
            element.required("name"),
            trigger.get(),
            ModelEvents.Direction.valueOf(direction.toUpperCase(Locale.ROOT)),
            ModelEvents.Action.valueOf(action.toUpperCase(Locale.ROOT)),
            changes,
            furtherChanges,
            names.origin(element)));
  }

  private boolean isState(Element set) {
    return names.signal(set.required("name")).isPresent();
  }

  private Optional<FurtherChange> furtherChange(Element set) {
    if (set.attribute("value").isEmpty()
        || set.attribute("posVals").isPresent()
        || set.attribute("velVals").isPresent()
        || set.attribute("unit").isPresent()) {
      error(set, "it sets a state; write value, and no other attribute");
      return Optional.empty();
    }
    Optional<Expression> value =
        formulas.read(AttributeText.of(set, "value"), Unit.ONE, FormulaRole.STATE);
    if (!(stateOf(set) instanceof Expression.StateValue state)) {
      error(
          set,
          "the name is that of an output, which follows from states; set one of those, whose names"
              + " end in .x1, .integral and the like");
      return Optional.empty();
    }
    return value.map(v -> new FurtherChange(state.index(), v));
  }

  private Expression stateOf(Element set) {
    try {
      return names.signal(set.required("name")).orElseThrow().value(0);
    } catch (ExpressionException e) {
      throw new IllegalStateException("all states have been read", e);
    }
  }

  private Optional<StateChange> change(Element set) {
    String name = set.required("name");
    Optional<ResolvedJoint> joint = names.joint(name);
    if (joint.isEmpty()) {
      diagnostics.error(
          MessageCode.UNKNOWN_NAME,
          set.position(),
          Phrase.of(
              "%s names joint %s, which does not exist%s",
              set.role(), Quoted.of(name), NearestName.suggestion(name, names.jointNames())));
      return Optional.empty();
    }
    if (set.attribute("value").isPresent()) {
      error(set, "it sets a joint; write posVals or velVals instead of value, which is for states");
      return Optional.empty();
    }
    if (joint.get().cut() || joint.get().driven()) {
      error(
          set,
          joint.get().cut()
              ? "the joint is cut, so its coordinates follow from those of other joints; set those"
                  + " instead"
              : "the joint is driven, so its coordinates cannot be set");
      return Optional.empty();
    }
    Optional<List<Expression>> q = list(set, "posVals", units.positions(set, joint.get().type()));
    Optional<List<Expression>> v = list(set, "velVals", units.velocities(set, joint.get().type()));
    return q.isPresent() && v.isPresent()
        ? Optional.of(new StateChange(joint.get().index(), q.get(), v.get()))
        : Optional.empty();
  }

  private Optional<List<Expression>> list(
      Element set, String attribute, Optional<List<Unit>> itemUnits) {
    return set.attribute(attribute).isEmpty()
        ? Optional.of(List.of())
        : itemUnits.flatMap(u -> formulas.list(set, attribute, u, FormulaRole.STATE));
  }

  private void error(Element element, String message) {
    diagnostics.error(
        MessageCode.EVENT_ACTION, element.position(), element.label() + ": " + message);
  }
}
