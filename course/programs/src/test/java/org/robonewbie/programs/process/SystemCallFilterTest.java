package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Verdicts of the filter, as an interpreter of its four instructions reaches them. */
class SystemCallFilterTest {

    private static final int ARCHITECTURE = 0xC000003E;
    private static final int ALLOWED = 0x7FFF0000;
    private static final int NO_SUCH_CALL = 0x00050026;

    private final SystemCallFilter filter = new SystemCallFilter(ARCHITECTURE, List.of(29, 68, 319));

    @ParameterizedTest
    @CsvSource({"0, true", "30, true", "29, false", "68, false", "319, false", "1073741824, false"})
    void listedCallsAndThoseOfTheOtherTableAreDenied(int call, boolean allowed) {
        assertThat(verdict(ARCHITECTURE, call)).isEqualTo(allowed ? ALLOWED : NO_SUCH_CALL);
    }

    @ParameterizedTest
    @CsvSource({"0", "30"})
    void everyCallOfAnotherProcessorIsDenied(int call) {
        assertThat(verdict(0x40000003, call)).isEqualTo(NO_SUCH_CALL);
    }

    private int verdict(int architecture, int call) {
        ByteBuffer program = ByteBuffer.wrap(filter.toBytes()).order(ByteOrder.nativeOrder());
        int loaded = 0;
        for (int line = 0; ; line++) {
            int code = program.getShort(8 * line);
            int value = program.getInt(8 * line + 4);
            boolean jumps;
            switch (code) {
                case 0x20 -> {
                    loaded = value == 0 ? call : architecture;
                    continue;
                }
                case 0x15 -> jumps = loaded == value;
                case 0x35 -> jumps = Integer.compareUnsigned(loaded, value) >= 0;
                default -> {
                    return value;
                }
            }
            line += program.get(8 * line + (jumps ? 2 : 3));
        }
    }
}
