/**
 * What is wrong with a model file: the catalogue of codes, the collector of diagnostics, and how
 * names are quoted and corrected in messages.
 */
@NullMarked
package org.mechservice.mechml.diagnosis;

import org.jspecify.annotations.NullMarked;
