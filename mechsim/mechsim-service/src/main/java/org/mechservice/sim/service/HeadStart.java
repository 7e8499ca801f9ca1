package org.mechservice.sim.service;

import java.io.IOException;
import java.util.List;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.NameValue;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads and builds a double pendulum while a process that serves itself alone is still starting its
 * ORB: two things that use no class of each other's, and load a thousand each. A server that goes
 * on to live does more, see {@link WarmUp}.
 */
public final class HeadStart {
  private static final Logger LOG = LoggerFactory.getLogger(HeadStart.class);

  private HeadStart() {}

  /** Begins; nobody waits for it, and what it makes is thrown away. */
  public static void begin() {
    Thread thread = new Thread(HeadStart::tried, "mechservice-head-start");
    thread.setDaemon(true);
    thread.start();
  }

  private static void tried() {
    try {
      run();
    } catch (MechmlException | InvalidOption | IOException | RuntimeException e) {
      LOG.warn(MessageCode.INTERNAL_SERVER_ERROR + " the model will take longer: {}", e.toString());
    }
  }

  /** Returns how many warnings the model has. */
  static int run() throws MechmlException, InvalidOption, IOException {
    LoadedModel model = LoadedModel.read(WarmUp.MODEL, WarmUp.content(), List.of(), false);
    SimulationSettings settings = model.model().settings();
    RunOptions asInFile =
        RunOptions.parse(new NameValue[0], settings).suiting(model.model().mechanism());
    try (ModelLibrary library = new ModelLibrary()) {
      library.compiled(model, asInFile.forRun(settings), new SetUpTimes());
    }
    return model.warnings().size();
  }
}
