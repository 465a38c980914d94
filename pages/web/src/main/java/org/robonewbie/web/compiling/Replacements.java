package org.robonewbie.web.compiling;

import java.util.Set;
import org.teavm.extension.spi.substitution.SimpleSubstitutionPolicy;
import org.teavm.extension.spi.substitution.SubstitutionSink;

/**
 * TeaVM policy that replaces classes with those of this module where TeaVM's library lacks them or has bugs: {@code java.util.HexFormat}
 * becomes {@code org.robonewbie.web.library.java.util.HexFormat}, and {@code StudentCode} becomes {@code PageStudentCode}.
 */
public final class Replacements extends SimpleSubstitutionPolicy {

    private static final String OURS = "org.robonewbie.web.library.";
    private static final Set<String> REPLACED = Set.of(
            "java.security.MessageDigest",
            "java.time.Instant",
            "java.util.Formatter",
            "java.util.HexFormat",
            "java.util.SplittableRandom",
            "org.slf4j.LoggerFactory");
    private static final Set<String> OTHERWISE_IN_A_PAGE = Set.of(
            "org.robonewbie.agent.log.StudentCode",
            "org.robonewbie.agent.running.PrototypeProbe",
            "org.robonewbie.agent.running.Surroundings",
            "org.robonewbie.nao.motion.file.MotionFiles");

    /** Creates the policy; TeaVM finds it by name. */
    public Replacements() {}

    @Override
    public void contribute(SubstitutionSink sink) {
        sink.selectClasses(REPLACED::contains).packagePrefix(OURS);
        sink.selectClasses(OTHERWISE_IN_A_PAGE::contains).packagePrefix(OURS).simpleNamePrefix("Page");
    }
}
