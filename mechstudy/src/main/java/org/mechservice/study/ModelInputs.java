package org.mechservice.study;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A model with as many of the wanted parameters as can be inputs of its code; masses, points or
 * settings depend on the others.
 *
 * @param model with the parameters as inputs
 * @param names those parameters
 */
public record ModelInputs(MechModel model, Set<String> names) {
  public ModelInputs {
    names = Set.copyOf(names);
  }

  /**
   * Makes parameters inputs of a model.
   *
   * @param wanted names of parameters of the model
   * @throws MechmlException if the model cannot be used
   */
  public static ModelInputs of(MechModel model, Collection<String> wanted) throws MechmlException {
    Optional<MechModel> all = with(model, Set.copyOf(wanted));
    if (all.isPresent()) {
      return new ModelInputs(all.get(), Set.copyOf(wanted));
    }
    MechModel read = model;
    Set<String> inputs = new LinkedHashSet<>();
    for (String name : wanted) {
      Optional<MechModel> more = with(read, Set.of(name));
      if (more.isPresent()) {
        read = more.get();
        inputs.add(name);
      }
    }
    return new ModelInputs(read, inputs);
  }

  /** Returns the model with more inputs; empty if one of them cannot be an input. */
  private static Optional<MechModel> with(MechModel model, Set<String> names)
      throws MechmlException {
    if (names.isEmpty()) {
      return Optional.of(model);
    }
    try {
      return Optional.of(model.tunable(names));
    } catch (MechmlException e) {
      if (e.diagnostics().stream()
          .noneMatch(d -> d.code() == MessageCode.TUNABLE_PARAMETER_MISPLACED)) {
        throw e;
      }
      return Optional.empty();
    }
  }
}
