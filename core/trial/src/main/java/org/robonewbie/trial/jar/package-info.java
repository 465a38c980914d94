/**
 * Look-up of service providers in external jars and folders by their simple class names.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.jar;
