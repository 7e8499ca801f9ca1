package org.mechservice.view.web;

import java.util.List;
import java.util.Map;
import org.mechservice.view.scene.SceneDescription;

/** Reads a model for its drawing. Called by several threads. */
public interface ModelReader {
  /**
   * Reads a model that the server has accepted.
   *
   * @param text the model in MechML
   * @param parameters values by the names of parameters
   * @throws RuntimeException if it cannot be read here; its message says why
   */
  ReadModel read(String text, Map<String, String> parameters);

  /**
   * A model that was read.
   *
   * @param scene its position at the start
   * @param parameters its parameters, in the order of the file
   */
  record ReadModel(SceneDescription scene, List<Parameter> parameters) {
    public ReadModel {
      parameters = List.copyOf(parameters);
    }
  }

  /**
   * A parameter of a model.
   *
   * @param name its name
   * @param unit its unit as the file writes it
   * @param value in this unit
   */
  record Parameter(String name, String unit, double value) {}
}
