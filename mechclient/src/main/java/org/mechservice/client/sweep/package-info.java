/** The same model with many values of its parameters, over all hosts of a server. */
@NullMarked
package org.mechservice.client.sweep;

import org.jspecify.annotations.NullMarked;
