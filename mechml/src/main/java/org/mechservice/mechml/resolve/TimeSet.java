package org.mechservice.mechml.resolve;

/**
 * When a run starts, ends and puts out rows.
 *
 * @param start s
 * @param end s; not before the start
 * @param step distance of the rows, s; positive
 */
record TimeSet(double start, double end, double step) {}
