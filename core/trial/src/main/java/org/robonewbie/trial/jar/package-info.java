/**
 * What jars and folders of other people offer by the simple names of their classes.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.jar;
