package org.mechservice.sim.service.setup;

import java.util.List;
import java.util.Map;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.ModelInfo;
import org.mechservice.idl.ModelReading;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.Parameter;
import org.mechservice.idl.RoadmapEntry;
import org.mechservice.idl.ServerFailure;
import org.mechservice.sim.model.GeneratedFacts;
import org.mechservice.sim.model.ModelClasses;
import org.mechservice.sim.packaging.JarImage;
import org.mechservice.sim.service.library.SetUpTimes;
import org.mechservice.solver.api.run.RunRequest;

/**
 * All that needs a model to be read: the answers to the calls of sessions. Every answer is a
 * function of its arguments, so that any process can give it; {@link SetUpsHere} gives it in this
 * process, {@link SetUpWorkers} in others.
 */
@SuppressWarnings("ArrayRecordComponent") // values of the contract, never compared
public interface SetUps {
  /**
   * A model that can be read.
   *
   * @param warnings of the reader and of the scene
   * @param spent time
   */
  record Loaded(Diagnostic[] warnings, SetUpTimes.Spent spent) {}

  /**
   * Source files of a model.
   *
   * @param spent time
   */
  record Sources(ModelFile[] files, SetUpTimes.Spent spent) {}

  /**
   * A model that was built for a run.
   *
   * @param generated facts about its code
   * @param files class files
   * @param request what is wanted of the run
   * @param earlierIds ids of the runs that it continues
   * @param messages for its events
   * @param warnings entries of the run report
   * @param spent time
   */
  record Built(
      GeneratedFacts generated,
      ModelClasses.Files files,
      RunRequest request,
      List<String> earlierIds,
      Diagnostic[] messages,
      Map<String, String> warnings,
      SetUpTimes.Spent spent) {}

  /**
   * The JAR of a model.
   *
   * @param runtime SHA-256 of the solver's JAR that it needs; empty: none
   * @param warnings entries of the run report
   * @param spent time
   */
  record Packed(
      JarImage jar, String runtime, Map<String, String> warnings, SetUpTimes.Spent spent) {}

  /**
   * A model of another format in MechML.
   *
   * @param losses what is not in it, then its warnings
   */
  record Translated(ModelFile model, Diagnostic[] losses) {}

  /** Reads a model, and generates it as its file says; a later request reports errors of that. */
  Loaded load(ModelFiles files) throws InvalidModel, LimitExceeded;

  /** Returns name, settings, formulation and states. */
  ModelInfo info(ModelFiles files) throws InvalidModel, LimitExceeded;

  /** Returns the parameters. */
  Parameter[] parameters(ModelFiles files) throws InvalidModel, LimitExceeded;

  /** Returns the place of each joint in the state. */
  RoadmapEntry[] roadmap(ModelFiles files) throws InvalidModel, LimitExceeded;

  /** Returns parameters, simulations and outputs of a model that is read with options. */
  ModelReading reading(ModelFiles files, NameValue[] options)
      throws InvalidModel, InvalidOption, LimitExceeded;

  /**
   * Returns the check report.
   *
   * @param options of the run that is to be checked; those of the file where there are none
   */
  String checkReport(ModelFiles files, NameValue[] options, boolean asJson)
      throws InvalidModel, InvalidOption, LimitExceeded;

  /** Returns the generated sources. */
  Sources sources(ModelFiles files, NameValue[] options)
      throws InvalidModel, InvalidOption, NotAvailable, LimitExceeded, ServerFailure;

  /** Builds a model for a run. */
  Built build(ModelFiles files, NameValue[] options)
      throws InvalidModel, InvalidOption, NotAvailable, LimitExceeded, ServerFailure;

  /** Builds the JAR of a model. */
  Packed pack(ModelFiles files, NameValue[] options)
      throws InvalidModel, InvalidOption, NotAvailable, LimitExceeded, ServerFailure;

  /**
   * Returns the check report of a model as JSON; empty if its text is, or cannot be read. Classes
   * of users are not needed.
   */
  String reportOf(String fileName, String text) throws LimitExceeded;

  /** Translates a model of another format; the suffix of its name is the format. */
  Translated translate(ModelFile foreign) throws InvalidModel, NotAvailable, LimitExceeded;
}
