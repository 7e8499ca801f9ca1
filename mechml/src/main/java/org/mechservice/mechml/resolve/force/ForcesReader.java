package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.mechml.Road;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** Reads {@code Forces} except gravity; the name of each element selects its reader. */
public final class ForcesReader {
  private static final Pattern CLASS_FILE =
      Pattern.compile("([A-Za-z0-9_$.]{1,300})\\.(class|java)");
  private static final Pattern IDENTIFIER = Pattern.compile("[A-Za-z_$][A-Za-z0-9_$]*+");

  private final SpringReader springs;
  private final JointForceReader jointForces;
  private final BushingReader bushings;
  private final ForceTorqueReader forceTorques;
  private final ContactReader contacts;
  private final ShapeContactReader shapes;
  private final TyreReader tyres;
  private final CouplingSpringReader couplings;
  private final PathForceReader paths;
  private final LawForceReader laws;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  /**
   * @param states receives the states of contacts that stick, of tyres and of muscles, behind those
   *     already there
   */
  public ForcesReader(
      ValueReader values,
      FormulaReader formulas,
      MechanismNames names,
      List<FurtherState> states,
      Diagnostics diagnostics) {
    this.springs = new SpringReader(formulas, names, diagnostics);
    this.jointForces = new JointForceReader(formulas, names, diagnostics);
    this.bushings = new BushingReader(values, formulas, names, diagnostics);
    this.forceTorques = new ForceTorqueReader(formulas, names, diagnostics);
    this.couplings = new CouplingSpringReader(values, formulas, names, diagnostics);
    this.paths = new PathForceReader(values, formulas, names, states, diagnostics);
    this.shapes = new ShapeContactReader(values, formulas, names, states, diagnostics);
    this.tyres = new TyreReader(values, formulas, names, states, diagnostics);
    this.contacts = new ContactReader(values, formulas, names, diagnostics);
    this.laws = new LawForceReader(formulas, names, diagnostics);
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns the forces without errors, in file order. */
  public List<ForceElement> read(Element model) {
    List<Element> elements = model.child("Forces").map(Element::children).orElse(List.of());
    NameTable<Element> taken = new NameTable<>("force", "does not exist", diagnostics);
    List<ForceElement> forces = new ArrayList<>();
    for (Element element : elements) {
      if (!element.name().equals("gravity")) {
        taken.add(element, Optional.of(element));
        forces.addAll(forces(element));
      }
    }
    return forces;
  }

  /**
   * Returns the surfaces of contacts and tyres whose height changes, by the names of their
   * elements; to be called for a file without errors.
   */
  public static Map<String, Road> roads(
      Element model,
      ValueReader values,
      FormulaReader formulas,
      MechanismNames names,
      Diagnostics diagnostics) {
    ContactReader contacts = new ContactReader(values, formulas, names, diagnostics);
    Map<String, Road> roads = new HashMap<>();
    for (Element force : model.child("Forces").map(Element::children).orElse(List.of())) {
      if (force.attribute("height").isPresent() || force.child("profile").isPresent()) {
        contacts.road(force).ifPresent(road -> roads.put(force.required("name"), road));
      }
    }
    return roads;
  }

  /** Returns the forces of an element; a coupling with backlash has two. */
  private List<? extends ForceElement> forces(Element element) {
    return switch (element.name()) {
      case "couplingSpringDamper" -> couplings.read(element);
      case "elasticRope" -> couplings.rope(element);
      default -> force(element).map(List::of).orElse(List.of());
    };
  }

  private Optional<? extends ForceElement> force(Element element) {
    return switch (element.name()) {
      case "springDamper" -> springs.read(element);
      case "torsionSpringDamper" -> jointForces.torsionSpringDamper(element);
      case "jointForce" -> jointForces.jointForce(element);
      case "friction" -> jointForces.friction(element);
      case "pathForce" -> paths.pathForce(element);
      case "muscle" -> paths.muscle(element);
      case "bushing" -> bushings.read(element);
      case "forceTorque" -> forceTorques.read(element);
      case "contact" -> contact(element);
      case "sphereContact", "discContact", "boxContact" -> shapes.read(element);
      case "tyre" -> tyres.read(element);
      case "force" -> userForce(element);
      default -> PairLaw.ofElement(element.name()).flatMap(law -> laws.read(element, law));
    };
  }

  private Optional<? extends ForceElement> contact(Element element) {
    if (element.attribute("stickLength").isEmpty() && element.attribute("stickTime").isEmpty()) {
      return contacts.read(element);
    }
    if (element.attribute("height").isEmpty() && element.child("profile").isEmpty()) {
      return shapes.read(element);
    }
    diagnostics.error(
        MessageCode.FORCE_ATTRIBUTES,
        element.position(),
        element.label()
            + ": stickLength needs a plane; leave height and <profile> out, or give frictionSpeed"
            + " instead");
    return Optional.empty();
  }

  private Optional<UserForceElement> userForce(Element element) {
    String fileName = element.required("fileName").strip();
    Optional<String> className = className(fileName);
    if (className.isPresent()) {
      return Optional.of(
          new UserForceElement(
              element.required("name"), className.get(), names.points(), names.origin(element)));
    }
    diagnostics.error(
        MessageCode.FORCE_CLASS_NAME,
        element.position(),
        Phrase.of(
            "%s: fileName is %s; it must be the full name of a class and .class or .java, as"
                + " car.Road.class",
            element.label(), Quoted.of(fileName)));
    return Optional.empty();
  }

  private static Optional<String> className(String fileName) {
    Matcher file = CLASS_FILE.matcher(fileName);
    if (!file.matches()) {
      return Optional.empty();
    }
    String name = String.valueOf(file.group(1));
    return Arrays.stream(name.split("\\.", -1)).allMatch(part -> IDENTIFIER.matcher(part).matches())
        ? Optional.of(name)
        : Optional.empty();
  }
}
