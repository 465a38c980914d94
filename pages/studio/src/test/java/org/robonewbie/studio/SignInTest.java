package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;

class SignInTest {

    private Instant now = Instant.parse("2026-01-01T08:00:00Z");
    private final SignIn signIn = new SignIn(AccessToken.random(), 3400, () -> now);

    @Test
    void codeWorksOnce() {
        String code = signIn.newCode();

        assertThat(signIn.redeem(code)).isTrue();
        assertThat(signIn.redeem(code)).isFalse();
    }

    @Test
    void codesDoNotReplaceEachOther() {
        String first = signIn.newCode();
        String second = signIn.newCode();

        assertThat(signIn.redeem(second)).isTrue();
        assertThat(signIn.redeem(first)).isTrue();
    }

    @Test
    void codeLastsTenMinutes() {
        String used = signIn.newCode();
        String late = signIn.newCode();

        now = now.plus(Duration.ofMinutes(10).minusNanos(1));
        assertThat(signIn.redeem(used)).isTrue();
        now = now.plusNanos(1);
        assertThat(signIn.redeem(late)).isFalse();
    }

    @Test
    void onlyACodeOfThisStudioWorks() {
        String code = signIn.newCode();
        SignIn other = new SignIn(AccessToken.random(), 3400, () -> now);

        assertThat(other.redeem(code)).isFalse();
        assertThat(signIn.redeem("")).isFalse();
        assertThat(signIn.redeem(code + "0")).isFalse();
        assertThat(signIn.redeem(code.substring(1))).isFalse();
        assertThat(signIn.redeem(code)).isTrue();
    }

    @Test
    void cookieIsOutOfReachOfScriptsAndOtherSitesAndNamesThePort() {
        String cookie = signIn.cookie();
        String value = cookie.substring(cookie.indexOf('=') + 1, cookie.indexOf(';'));

        assertThat(cookie)
                .startsWith("robonewbie-studio-3400=")
                .contains("; HttpOnly", "; SameSite=Strict", "; Path=/");
        assertThat(signIn.cookieName()).isEqualTo("robonewbie-studio-3400");
        assertThat(signIn.admits(value)).isTrue();
        assertThat(signIn.admits(signIn.newCode())).isFalse();
        assertThat(signIn.admits("")).isFalse();
    }

    @Test
    void eachAddressHoldsACodeOfItsOwn() {
        URI page = URI.create("http://127.0.0.1:3400/");

        URI first = signIn.newAddress(page);

        assertThat(first.toString()).startsWith("http://127.0.0.1:3400/?code=");
        assertThat(signIn.newAddress(page)).isNotEqualTo(first);
        assertThat(signIn.redeem(first.getQuery().substring("code=".length()))).isTrue();
    }
}
