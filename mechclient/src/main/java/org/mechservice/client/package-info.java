/** The client library: connect, run remotely, fetch and run locally, results to files. */
@NullMarked
package org.mechservice.client;

import org.jspecify.annotations.NullMarked;
