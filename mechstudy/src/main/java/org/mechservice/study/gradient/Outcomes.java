package org.mechservice.study.gradient;

/**
 * Values with their derivatives by all directions, in the directions' own measures.
 *
 * @param values one for each wanted number
 * @param slopes a row for each
 * @param steps of the integration of the motion
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record Outcomes(double[] values, double[][] slopes, long steps) {}
