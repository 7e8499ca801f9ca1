/**
 * Running a model from start to end: rows at the requested times, energy watched, control from
 * outside obeyed, and a report of what happened.
 */
package org.mechservice.solver.simulation;
