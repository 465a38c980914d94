package org.robonewbie.studio;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Opens a page for the tests of a class in a browser that all classes share, and passes it to the constructor. Tests are skipped without
 * a browser on this computer. The page is drawn coarsely until {@link Chromium#drawSharply()}. It is left after each test, before the
 * test closes its studio.
 */
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(BrowserForTests.class)
@interface InBrowser {

    /** Width of the page in pixels. */
    int width() default 1366;

    /** Height of the page in pixels. */
    int height() default 768;

    /** Whether the user has not yet skipped the levels of the first minute. */
    boolean newcomer() default false;
}
