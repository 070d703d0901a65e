// A shared library, but no plug-in.
extern "C" int nothing() { return 0; }
