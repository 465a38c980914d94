package org.robonewbie.web.compiling;

import java.util.Set;
import org.teavm.extension.spi.substitution.SimpleSubstitutionPolicy;
import org.teavm.extension.spi.substitution.SubstitutionSink;

/**
 * Puts classes of this module in the place of those that TeaVM's class library lacks: {@code java.util.HexFormat} becomes {@code
 * org.robonewbie.web.library.java.util.HexFormat}.
 */
public final class Replacements extends SimpleSubstitutionPolicy {

    private static final String OURS = "org.robonewbie.web.library.";
    private static final Set<String> REPLACED =
            Set.of("java.security.MessageDigest", "java.util.HexFormat", "org.slf4j.LoggerFactory");

    /** Creates the policy; TeaVM finds it by its name. */
    public Replacements() {}

    @Override
    public void contribute(SubstitutionSink sink) {
        sink.selectClasses(REPLACED::contains).packagePrefix(OURS);
    }
}
