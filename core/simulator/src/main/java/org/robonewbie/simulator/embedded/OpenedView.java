package org.robonewbie.simulator.embedded;

import org.robonewbie.simulator.Console;

/**
 * A view of a program's simulation, and what the terminal says about it.
 *
 * @param view the view
 * @param hint text to print after an address of the view
 */
public record OpenedView(Viewer.View view, String hint) {

    /**
     * Listens for the Enter key and opens the browser.
     *
     * @param view the view
     * @param openBrowser whether to open the view in the user's browser
     * @return the view and its hint
     */
    public static OpenedView of(Viewer.View view, boolean openBrowser) {
        String hint = EnterKey.listen(view);
        if (openBrowser) {
            Browser.openUnlessWatched(view, Console.standard());
        }
        return new OpenedView(view, hint);
    }

    /** {@return a message to print: a new one-time address, and the hint} */
    public String address() {
        return view.oneTimeAddress() + hint;
    }
}
