/**
 * The library in process: read, build, simulate and analyse a model without a server. It runs the
 * same generator and the same solver as the service, so that its results are the same bits.
 */
@NullMarked
package org.mechservice.library;

import org.jspecify.annotations.NullMarked;
