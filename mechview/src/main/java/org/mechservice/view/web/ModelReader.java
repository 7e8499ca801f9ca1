package org.mechservice.view.web;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.view.scene.SceneDescription;

/** Reads a model for its drawing. Called by several threads. */
public interface ModelReader {
  /**
   * Reads a model that the server has accepted.
   *
   * @param text the model in MechML
   * @param choice what of the model is wanted
   * @throws RuntimeException if it cannot be read here; its message says why
   */
  ReadModel read(String text, Choice choice);

  /**
   * The choice of simulation and values in a model.
   *
   * @param simulation name or number, from 1, of a simulation; empty: the first
   * @param parameters values by the names of parameters
   */
  record Choice(Optional<String> simulation, Map<String, String> parameters) {
    public Choice {
      parameters = Map.copyOf(parameters);
    }
  }

  /**
   * A model that was read.
   *
   * @param scene its position at the start
   * @param parameters its parameters, in the order of the file
   * @param simulations its simulations in words, in the order of the file
   */
  record ReadModel(SceneDescription scene, List<Parameter> parameters, List<String> simulations) {
    public ReadModel {
      parameters = List.copyOf(parameters);
      simulations = List.copyOf(simulations);
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
