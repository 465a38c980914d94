package org.robonewbie.studio;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.junit.jupiter.api.extension.AfterTestExecutionCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;

/** JUnit extension of {@link InBrowser}: one browser for all classes with a new page for each, closed after the last class. */
final class BrowserForTests implements BeforeAllCallback, AfterTestExecutionCallback, ParameterResolver {

    /** Statement that makes the page's user no newcomer. */
    static final String SKIP_FIRST_MINUTE =
            "try { localStorage.setItem('robonewbie-first-minute-skipped', 'true'); } catch { /* no storage */ }";

    @Override
    public void beforeAll(ExtensionContext context) {
        Tool.BROWSER.orSkip();
        InBrowser wanted = context.getRequiredTestClass().getAnnotation(InBrowser.class);
        browser(context).openPage(wanted.width(), wanted.height());
        if (!wanted.newcomer()) {
            browser(context).runBeforePages(SKIP_FIRST_MINUTE);
        }
        browser(context).drawCoarsely();
    }

    @Override
    public void afterTestExecution(ExtensionContext context) {
        browser(context).evaluate("(() => { try { localStorage.clear(); } catch { return; } })()");
        browser(context).visit("about:blank");
        browser(context).drawCoarsely();
        browser(context).forgetComplaints();
    }

    @Override
    public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
        return parameter.getParameter().getType() == Chromium.class;
    }

    @Override
    public Chromium resolveParameter(ParameterContext parameter, ExtensionContext context) {
        return browser(context);
    }

    private static Chromium browser(ExtensionContext context) {
        return context.getRoot()
                .getStore(Namespace.create(BrowserForTests.class))
                .computeIfAbsent(Chromium.class, type -> start(), Chromium.class);
    }

    private static Chromium start() {
        try {
            return Chromium.start();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
