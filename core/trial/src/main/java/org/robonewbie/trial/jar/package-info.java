/**
 * Service providers of external jars and folders, found by their simple class names.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.jar;
