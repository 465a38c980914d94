package org.robonewbie.site;

import java.util.List;

/** Links in the documentation lead nowhere. */
public final class BrokenLinksException extends RuntimeException {

    private static final long serialVersionUID = 1;

    BrokenLinksException(List<String> broken) {
        super("Correct these links of the documentation:\n  " + String.join("\n  ", broken));
    }
}
