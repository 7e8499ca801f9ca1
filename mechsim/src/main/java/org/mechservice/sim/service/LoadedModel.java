package org.mechservice.sim.service;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.OPT_SIMULATION;
import org.mechservice.mechml.MechmlException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.MechmlReader;
import org.mechservice.mechml.SimulationSettings;

/**
 * A model file as a session holds it.
 *
 * @param fileName its name, for messages
 * @param sha256 SHA-256 of its bytes, lower-case hexadecimal
 * @param text its bytes as UTF-8, for people to look at
 * @param model what it says
 */
record LoadedModel(String fileName, String sha256, String text, MechmlModel model) {

  /**
   * Reads a model file.
   *
   * @throws MechmlException if it cannot be used
   */
  static LoadedModel read(String fileName, byte[] content) throws MechmlException {
    return new LoadedModel(
        fileName,
        sha256(content),
        new String(content, StandardCharsets.UTF_8),
        MechmlReader.read(fileName, content));
  }

  private static String sha256(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Returns the model with another of its file's simulations.
   *
   * @param simulation name of a simulation, or its number from 1
   * @throws InvalidOption if the file has none of that name
   */
  LoadedModel choosing(String simulation) throws InvalidOption {
    List<SimulationSettings> all = model.simulations();
    for (int i = 0; i < all.size(); i++) {
      if (all.get(i).name().equals(simulation)) {
        return with(all.get(i));
      }
    }
    for (int i = 0; i < all.size(); i++) {
      if (Integer.toString(i + 1).equals(simulation)) {
        return with(all.get(i));
      }
    }
    throw Refusal.option(
        OPT_SIMULATION.value,
        "the file has no simulation \"" + simulation + "\"; it has " + names(all));
  }

  private static String names(List<SimulationSettings> all) {
    return IntStream.range(0, all.size())
        .mapToObj(
            i -> (i + 1) + (all.get(i).name().isEmpty() ? "" : " (\"" + all.get(i).name() + "\")"))
        .collect(Collectors.joining(", "));
  }

  private LoadedModel with(SimulationSettings settings) {
    return new LoadedModel(
        fileName,
        sha256,
        text,
        new MechmlModel(
            model.mechanism(),
            settings,
            model.simulations(),
            model.outputs(),
            model.unused(),
            model.warnings()));
  }
}
