package org.mechservice.view.web;

import java.io.IOException;
import java.nio.file.Path;
import org.mechservice.client.MechSession;
import org.mechservice.orb.http.RefusedRequestException;

/**
 * Exports of a model that the page offers beside its runs. They need more than a client of the
 * service has, so the program around the page makes them. Called by several threads.
 */
public interface ModelExports {
  /**
   * Builds the Functional Mock-up Unit of a model that the server has accepted.
   *
   * @param text the model in MechML
   * @param choice simulation and values of parameters
   * @return the bytes of the file
   * @throws RefusedRequestException if the model cannot be such a unit; says why
   * @throws IOException if it cannot be built here
   */
  byte[] unit(String text, ModelReader.Choice choice) throws IOException;

  /**
   * Measures error against run time of every method that fits a model, and writes the page.
   *
   * @param session with the model loaded
   * @param folder for the page and the data that it links to
   * @param progress told often; what it throws ends the measurement
   * @return the page, in the folder
   * @throws IOException if a file cannot be written
   * @throws InterruptedException if interrupted
   */
  Path report(MechSession session, Path folder, Progress progress)
      throws IOException, InterruptedException;

  /** Returns the content security policy under which pages of {@link #report} can be served. */
  String reportPolicy();

  /** Hears how far a measurement is. */
  interface Progress {
    /**
     * Hears of it.
     *
     * @param what the current work, in a few words
     * @param done part of the whole, from 0 to 1
     * @param secondsLeft estimated, s; NaN if not known yet
     */
    void at(String what, double done, double secondsLeft);
  }
}
