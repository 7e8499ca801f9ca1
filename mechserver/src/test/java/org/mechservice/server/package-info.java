@NullMarked
package org.mechservice.server;

import org.jspecify.annotations.NullMarked;
