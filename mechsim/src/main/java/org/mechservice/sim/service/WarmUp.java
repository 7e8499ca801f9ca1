package org.mechservice.sim.service;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Objects;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAvailable;
import org.mechservice.mechml.MechmlException;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.sim.build.CompiledModel;
import org.mechservice.sim.build.ModelFactory;
import org.mechservice.sim.build.jar.Packing;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Makes the MechSims of a process ready before its first client comes: a double pendulum is read,
 * built and packed as a client's model would be, which loads the classes that the first model of a
 * process otherwise waits for. A MechSim itself is opened in a millisecond and is not kept in
 * stock.
 */
public final class WarmUp {
  private static final Logger LOG = LoggerFactory.getLogger(WarmUp.class);
  private static final String MODEL = "warm-up.xml";

  private WarmUp() {}

  /** Begins; a client that comes meanwhile is served as ever. */
  public static void begin() {
    Thread thread = new Thread(WarmUp::tried, "mechservice-warm-up");
    thread.setDaemon(true);
    thread.start();
  }

  private static void tried() {
    try {
      run();
    } catch (MechmlException | InvalidOption | NotAvailable | IOException | RuntimeException e) {
      LOG.warn("S-001 the first client will wait longer: {}", e.toString());
    }
  }

  /** Builds and packs the model; returns how many warnings it has. */
  static int run() throws MechmlException, InvalidOption, NotAvailable, IOException {
    LoadedModel model = LoadedModel.read(MODEL, content(), List.of(), false);
    SimulationSettings settings = model.model().settings();
    RunOptions asInFile = RunOptions.parse(new NameValue[0], settings);
    try (ModelLibrary library = new ModelLibrary()) {
      SetUpTimes times = new SetUpTimes();
      library.compiled(model, asInFile.forRun(settings), times);
      CompiledModel compiled = library.compiled(model, asInFile.forJar(), times);
      ModelFactory.modelJar(compiled, model.sha256(), Packing.QUICK);
    }
    return model.warnings().size();
  }

  private static byte[] content() throws IOException {
    try (InputStream in = WarmUp.class.getResourceAsStream(MODEL)) {
      return Objects.requireNonNull(in).readAllBytes();
    }
  }
}
