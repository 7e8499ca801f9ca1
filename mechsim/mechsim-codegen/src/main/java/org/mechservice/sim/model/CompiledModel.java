package org.mechservice.sim.model;

import java.util.SortedMap;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.user.IdleForces;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;

/**
 * A generated model, its class files and the model file that it was generated from. Immutable;
 * shared freely between threads.
 */
public final class CompiledModel {
  private final MechmlModel source;
  private final BuildOptions options;
  private final ModelClasses classes;

  /**
   * Loads the class of a model.
   *
   * @param source model file that it was generated from
   * @param generated facts about its code
   * @param options options of the build
   * @param classFiles class file bytes by binary class name; not modified
   * @param userClasses the classes of its users' forces
   */
  CompiledModel(
      MechmlModel source,
      GeneratedModel generated,
      BuildOptions options,
      SortedMap<String, byte[]> classFiles,
      UserClasses userClasses) {
    this.source = source;
    this.options = options;
    classes =
        new ModelClasses(
            generated.facts(),
            new ModelClasses.Files(
                classFiles, userClasses.classFiles(), IdleForces.of(source.mechanism())),
            userClasses::loader);
  }

  /** Returns the model file that it was generated from. */
  public MechmlModel source() {
    return source;
  }

  /** Returns its classes, which run without the model file. */
  public ModelClasses classes() {
    return classes;
  }

  /** Returns the facts about its code; the plan of the code is not kept. */
  public GeneratedFacts generated() {
    return classes.generated();
  }

  /** Returns the options of the build. */
  public BuildOptions options() {
    return options;
  }

  /**
   * Returns class file bytes by binary class name, including user classes; must not be modified.
   */
  public SortedMap<String, byte[]> classFiles() {
    return classes.all();
  }

  /** Returns the class files of its users, by binary class name; not to be modified. */
  public SortedMap<String, byte[]> userClassFiles() {
    return classes.files().ofUsers();
  }

  /** Returns whether the model contains user classes. */
  public boolean hasUserClasses() {
    return classes.hasUserClasses();
  }

  /**
   * Returns an instance for queries of names, units, columns and settings. User classes are not
   * loaded for it; their forces are zero.
   */
  public Model withoutUserClasses() {
    return classes.describing().model();
  }

  /**
   * Returns a new instance of the model, for one run; see {@link ModelClasses#instances}.
   *
   * @throws IllegalArgumentException S-068 if a user class cannot be used, S-168 if this machine
   *     cannot confine it
   */
  public Model newInstance() {
    return classes.newInstance();
  }

  /** Returns a source of instances of the model; see {@link ModelClasses#instances}. */
  public ModelSource instances() {
    return classes.instances();
  }
}
