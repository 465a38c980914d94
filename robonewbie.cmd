@echo off
rem Runs RoboNewbie, and builds it first where that is needed. Needs a JDK 17 or newer and nothing else.
rem The program itself is app\src\main\java\org\robonewbie\app\Main.java; "robonewbie" is this script for Linux and macOS.
setlocal EnableExtensions
set "HOME_FOLDER=%~dp0"
set "HOME_FOLDER=%HOME_FOLDER:~0,-1%"
set "LAUNCH=%HOME_FOLDER%\app\target\launch"
set "LOG=%LAUNCH%\build.log"

set "JAVA="
set "FOUND=no Java at all"
if defined JAVA_HOME call :try_java "%JAVA_HOME%\bin\java.exe"
if not defined JAVA for %%j in (java.exe) do call :try_java "%%~$PATH:j"
if not defined JAVA goto no_java

set "JAR=%HOME_FOLDER%\lib\robonewbie.jar"
if exist "%JAR%" goto start
call :find_jar
call :is_fresh
if errorlevel 1 call :build
if errorlevel 1 exit /b 1
call :find_jar
:start
"%JAVA%" -XX:+UseSerialGC -Xshare:auto "-Drobonewbie.home=%HOME_FOLDER%" -jar "%JAR%" %*
exit /b %ERRORLEVEL%

:no_java
>&2 echo robonewbie: Java 17 or newer is needed. Found: %FOUND%.
>&2 echo   Install a JDK, for example Temurin from https://adoptium.net (any version from 17 on),
>&2 echo   open a new window and try again. If it is installed already, set JAVA_HOME to its folder.
exit /b 1

rem Takes a java.exe if it is new enough. It tells: openjdk version "17.0.15" 2025-04-15
:try_java
if "%~1"=="" exit /b 0
if not exist "%~1" exit /b 0
set "MAJOR=0"
set "TOLD=%TEMP%\robonewbie-%RANDOM%.txt"
"%~1" -version 2>"%TOLD%"
for /f "usebackq tokens=2,3" %%a in ("%TOLD%") do if "%%a"=="version" set "MAJOR=%%~b"
del "%TOLD%"
for /f "tokens=1 delims=.-+" %%m in ("%MAJOR%") do set "MAJOR=%%m"
if %MAJOR% GEQ 17 (set "JAVA=%~1") else (set "FOUND=%~1 (%MAJOR%)")
exit /b 0

rem The newest program: while one runs Windows keeps its file, so that each build gets a name of its own.
:find_jar
set "JAR="
for /f "delims=" %%f in ('dir /b /on "%LAUNCH%\robonewbie-*.jar" 2^>nul') do set "JAR=%LAUNCH%\%%f"
exit /b 0

:is_fresh
if not defined JAR exit /b 1
powershell -NoProfile -Command "Set-Location -LiteralPath $env:HOME_FOLDER; $built = (Get-Item -LiteralPath $env:JAR).LastWriteTimeUtc; $newer = Get-ChildItem -Path pom.xml, */pom.xml, */src/main, docs -Recurse -File | Where-Object { $_.LastWriteTimeUtc -gt $built } | Select-Object -First 1; if ($newer) { exit 1 }"
exit /b %ERRORLEVEL%

rem One window builds, the others wait, at most five minutes: the folder "lock" can be made only once.
:build
if not exist "%LAUNCH%" md "%LAUNCH%" 2>nul
if not exist "%LAUNCH%" goto not_writable
set "SECONDS=0"
:wait_for_lock
md "%LAUNCH%\lock" 2>nul
if not errorlevel 1 goto have_lock
if %SECONDS%==0 echo RoboNewbie is being built in another window; waiting for it ...
if %SECONDS%==60 echo Is there no other window? Then delete the folder %LAUNCH%\lock
ping -n 2 127.0.0.1 >nul
set /a SECONDS+=1
if %SECONDS% LSS 300 goto wait_for_lock
:have_lock
call :build_alone
set "RESULT=%ERRORLEVEL%"
rd "%LAUNCH%\lock" 2>nul
exit /b %RESULT%

:not_writable
>&2 echo robonewbie: cannot write into %HOME_FOLDER%\app\target.
>&2 echo   RoboNewbie has to be built once. Copy its folder to a place where you may write, such as your home folder.
exit /b 1

:no_compiler
>&2 echo robonewbie: the Java in %JAVA_HOME% has no compiler (javac).
>&2 echo   Install a JDK 17 or newer instead of a Java run-time (JRE).
exit /b 1

:build_alone
call :find_jar
call :is_fresh
if not errorlevel 1 exit /b 0
if defined JAR (echo Sources have changed: building RoboNewbie, about 20 s ...) else (echo Building RoboNewbie for the first time: it downloads Maven and libraries, 1 to 3 minutes ...)
for /f %%t in ('powershell -NoProfile -Command "Get-Date -Format yyyyMMddHHmmss"') do set "STARTED=%%t"
for %%b in ("%JAVA%") do for %%h in ("%%~dpb..") do set "JAVA_HOME=%%~fh"
if not exist "%JAVA_HOME%\bin\javac.exe" goto no_compiler
pushd "%HOME_FOLDER%"
call "%HOME_FOLDER%\mvnw.cmd" -B -P-lint -Dmaven.test.skip=true -pl app -am package >"%LOG%" 2>&1
set "RESULT=%ERRORLEVEL%"
popd
if not "%RESULT%"=="0" goto explain_failure
powershell -NoProfile -Command "$new = Join-Path $env:LAUNCH ('robonewbie-' + $env:STARTED + '.jar'); Copy-Item -LiteralPath (Join-Path $env:HOME_FOLDER 'app\target\robonewbie.jar') -Destination ($new + '.new'); (Get-Item -LiteralPath ($new + '.new')).LastWriteTime = [datetime]::ParseExact($env:STARTED, 'yyyyMMddHHmmss', $null); Move-Item -LiteralPath ($new + '.new') -Destination $new; Get-ChildItem -LiteralPath $env:LAUNCH -Filter 'robonewbie-*.jar' | Where-Object { $_.FullName -ne $new } | Remove-Item -ErrorAction SilentlyContinue"
echo RoboNewbie is built.
exit /b 0

:explain_failure
echo The build of RoboNewbie failed:
echo.
findstr /l /v /b /c:"Download" /c:"[INFO]" "%LOG%"
echo.
findstr /l /c:"COMPILATION ERROR" "%LOG%" >nul
if errorlevel 1 (
  echo What to do: the first build needs the internet; check the connection and try again. Else read the first ERROR above.
) else (
  echo What to do: correct the Java file and line that the first ERROR names. "git diff" shows what you changed.
)
echo The whole output is in %LOG%
exit /b 1
