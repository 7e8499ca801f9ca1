package org.mechservice.study.run;

import org.mechservice.mechml.unit.Unit;

/**
 * A factor as the study file gives it.
 *
 * @param name parameter of the model
 * @param unit name of the unit of its values in the study
 * @param given this unit
 * @param own unit that the model file gives the parameter
 */
record StudyFactor(String name, String unit, Unit given, Unit own) {
  /** Returns a value of the study in the unit of the model file. */
  double inModel(double value) {
    return given.equals(own) ? value : own.fromSi(given.toSi(value));
  }

  @Override
  public String toString() {
    return unit.equals("1") ? name : name + " in " + unit;
  }
}
