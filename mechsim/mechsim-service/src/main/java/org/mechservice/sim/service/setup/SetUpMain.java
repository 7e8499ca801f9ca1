package org.mechservice.sim.service.setup;

import java.io.IOException;
import org.mechservice.guard.WarmMain;
import org.mechservice.sim.service.library.ClassLibrary;

/** Main class of a process that reads, generates and builds models for a host. */
final class SetUpMain {
  private SetUpMain() {}

  /** Answers calls on standard input, until it ends. */
  public static void main(String[] arguments) throws IOException {
    try (SetUpsHere here = new SetUpsHere(new ClassLibrary())) {
      WarmMain.serve(
          (operation, in, out) -> SetUpCall.answer(here, operation, in, out), Long.MAX_VALUE);
    }
  }
}
