/**
 * Mechanisms as bytes: the compact form of a model, in which data instead of generated code travel.
 */
package org.mechservice.solver.compact;
