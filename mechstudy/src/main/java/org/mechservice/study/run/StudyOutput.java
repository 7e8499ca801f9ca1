package org.mechservice.study.run;

import java.util.OptionalDouble;
import org.mechservice.mechml.unit.Unit;

/**
 * A column of the table with values of the runs.
 *
 * @param name its name
 * @param of what it is of a run, such as {@code max(height.a)}
 * @param unit name of its unit
 * @param scale its unit, in which values are written
 * @param failing what a failing point counts as in statistics; empty if it is left out there
 */
record StudyOutput(String name, String of, String unit, Unit scale, OptionalDouble failing) {}
